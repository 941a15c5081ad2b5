// SPDX-License-Identifier: MIT
// How a device is held: the eye goes round the sphere as the device is turned, as if its display were a window.
#pragma once
#pragma GCC system_header

#include "lumi/camera.h"

namespace lumi
{

// A turn from the device's axes to those of the sphere, of any length: Q14 as sensors give it, or any other numbers. Of
// the device, x is to the right of the display, y up along it, z out of it towards its user.
struct Quaternion {
    int32_t w, x, y, z;
};

// Places the eye at `distance` in the direction of the device's z, looking back at the centre. All zeros are no turn.
// Angles are right to 1/100 degree for numbers of 14 bits or more. Cost: one root, 25 products of 64 bits.
Pose held_pose(const Quaternion& turn, int32_t distance_q20);

}  // namespace lumi
