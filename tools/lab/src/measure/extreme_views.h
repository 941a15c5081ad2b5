// SPDX-License-Identifier: MIT
// Views at the ends of what poses and images can be.
#pragma once

#include <vector>

#include "lumi/camera.h"

namespace lumi::lab
{

struct View {
    Pose pose;
    Image image;
};

inline constexpr uint32_t kDegree = 11930465;  // a turn has 2^32
inline constexpr Image kUsual = {96, 96, 40 * kDegree};

// Looks towards the middle of the sphere, from so many radii.
Pose from(double azimuth_deg, double elevation_deg, double distance);
// Turns a view about its axis.
Pose rolled(const Pose& pose, double degrees);
// Looks from all around at a distance.
std::vector<View> around(double distance, const Image& image = kUsual);
// A pair of eyes, and an image whose axis lies beside its middle.
std::vector<View> stereo();

}  // namespace lumi::lab
