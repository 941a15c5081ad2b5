// SPDX-License-Identifier: MIT
// The views that quality is measured from: none of them is one that a bake has aimed at.
#pragma once

#include <string>
#include <vector>

#include "draw/views.h"

namespace lumi::quality
{

enum class ViewSet : uint8_t { all, upper, ring };
const char* name_of(ViewSet set);

inline constexpr int kHeldOutViews = 12;
inline constexpr int kViewSidePx = 240;

struct HeldOutView {
    double azimuth_deg, elevation_deg, distance;
    tools::Eye eye;
};

// `count` views of side_px × side_px pixels from 2.5 to 4 radii, the sphere filling the frame:
// all: a Spherical Fibonacci set over the whole sphere, turned by kTurnDeg so that it is no field's set of origins;
// upper: the same over the upper half; ring: around the clock, 15 to 25 degrees high. `cap`: of all, that uppermost
// share of the sphere.
std::vector<HeldOutView> held_out_views(ViewSet set, int count = kHeldOutViews, int side_px = kViewSidePx,
                                        double cap = 1);

// The view of one orbit, the sphere filling the frame. Throws UsageError where it cannot be drawn.
HeldOutView view_at(double azimuth_deg, double elevation_deg, double distance, int side_px);

// "azimuth 123, elevation -45, distance 3.1".
std::string text_of(const HeldOutView& view);

}  // namespace lumi::quality
