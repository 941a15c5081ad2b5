// SPDX-License-Identifier: MIT
// Firmware without a field would have a sheet of path-traced sprites, RGB565 or JPEG, and turn and scale the one
// nearest to the view onto the screen.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/picture.h"
#include "lumi/baker/scene.h"
#include "lumi/bench/views.h"

namespace lumi::bench
{

struct SpriteSheet {
    uint32_t count = 1;         // a Spherical Fibonacci set all around
    uint32_t samples = 16;      // light paths a pixel; what remains of noise is far below the error of a wrong view
    int32_t side_px = kSidePx;  // a sprite's side
    uint32_t jpeg_bytes = 0;    // a sprite's size at most, in the best quality that fits; 0: RGB565
};

// Returns the nearest sprite as the view's picture.
tools::Picture sprite_picture(const baker::Scene& scene, const SpriteSheet& sheet, const View& view);

}  // namespace lumi::bench
