// SPDX-License-Identifier: MIT
// An 8-bit sRGB picture that repeats over the plane, read with bilinear filtering in linear light.
#pragma once

#include <cstdint>
#include <vector>

#include "vec3.h"

namespace lumi::baker
{

struct Texture {
    int width = 0, height = 0;  // > 0
    std::vector<uint8_t> rgb;   // 3 bytes a pixel, top row first

    // u to the right, v upwards, the picture fills [0,1]².
    Rgb at(const Vec2& uv) const;
};

}  // namespace lumi::baker
