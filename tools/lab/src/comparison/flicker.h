// SPDX-License-Identifier: MIT
// How restless a surface field looks while the eye moves away slowly: what changes between two frames besides what
// should.
#pragma once

#include <vector>

#include "draw/draw_surface.h"

namespace lumi::quality
{

struct Flicker {
    SurfaceMode mode;
    double rms_levels;  // levels out of 255
    double ratio;       // to the levels of 2×2
};

inline constexpr double kZoomNearest = 1.05, kZoomFarthest = 20;  // radii
inline constexpr int kZoomFrames = 300;

// Draws a zoom of so many frames, each the same factor further away, in every mode. From the change of each pixel
// between two frames that of a picture with 64 samples a pixel of the same field is taken; the root mean square is over
// the pixels where something is seen. Cost: about 20 drawings of a frame for each.
std::vector<Flicker> zoom_flicker(const SurfaceField& field, int frames = kZoomFrames, int side_px = 240);

}  // namespace lumi::quality
