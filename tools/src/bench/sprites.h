// SPDX-License-Identifier: MIT
// What one would do without a field: a sheet of path-traced RGB565 sprites, the one nearest to the view turned and
// scaled onto the screen.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "image/picture.h"
#include "lumi/baker/scene.h"
#include "lumi/bench/views.h"

namespace lumi::bench
{

// The path-traced truth of a view over kBackgroundColour.
tools::Picture traced_view(const baker::Scene& scene, const Pose& pose, const Image& image, uint32_t samples);

// Which of `count` sprites, seen from a Spherical Fibonacci set of directions at kFarQ20, lies nearest to the view.
uint32_t nearest_sprite(uint32_t count, const View& view);

// That sprite, of side_px × side_px pixels, as the view's picture.
tools::Picture sprite_picture(const baker::Scene& scene, uint32_t count, const View& view, uint32_t samples,
                              int32_t side_px = kSidePx);

}  // namespace lumi::bench
