// SPDX-License-Identifier: MIT
// What a pixel sees of a guided field's surface.
#pragma once

#include <cstdint>

namespace lumi
{

// A point X in the unit sphere's frame, |component| <= 2, and how many of the pixel's samples see it.
struct SurfacePoint {
    int32_t x_q14, y_q14, z_q14;
    uint32_t samples;
};

}  // namespace lumi
