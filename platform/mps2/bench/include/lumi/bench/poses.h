// SPDX-License-Identifier: MIT
// Poses all around the sphere, near and far and rolled, for the worst case of a frame: both poles in four rolls, then
// turns at random. The sphere fills the image from every distance.
#pragma once

#include "lumi/attitude.h"
#include "lumi/bench/views.h"
#include "lumi/orbit.h"

namespace lumi::bench
{

inline constexpr uint32_t kPoses = 200;

struct PosedView {
    Pose pose;
    Image image;
};

// Vectors may have any length, but no sum of squares is 0.
inline Quaternion turn_of(uint32_t number)
{
    constexpr uint32_t kRolls = 4;
    constexpr int32_t kRollCosine[kRolls] = {16384, 15137, 11585, 0},
                      kRollSine[kRolls] = {0, 6270, 11585, 16384};  // Q14
    if (number < kRolls) return {kRollCosine[number], 0, 0, kRollSine[number]};
    if (number < 2 * kRolls) return {0, kRollCosine[number - kRolls], kRollSine[number - kRolls], 0};
    uint32_t state = number * 0x9E3779B9u;
    const auto random = [&state] {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        return static_cast<int32_t>(state) >> 17;  // 15 bits
    };
    while (true) {
        const Quaternion q = {random(), random(), random(), random()};
        const int64_t length2 = int64_t{q.w} * q.w + int64_t{q.x} * q.x + int64_t{q.y} * q.y + int64_t{q.z} * q.z;
        if (length2 >= int64_t{1} << 24 && length2 <= int64_t{1} << 28) return q;  // within a ball: all turns alike
    }
}

inline PosedView posed_view(uint32_t number)
{
    constexpr int32_t kDistances[] = {radii(6) / 5, radii(3) / 2, radii(2), radii(3), radii(6)};
    const int32_t distance = kDistances[number % (sizeof kDistances / sizeof *kDistances)];
    return {held_pose(turn_of(number), distance), {kSidePx, kSidePx, fit_sphere(kSidePx, kSidePx, distance)}};
}

}  // namespace lumi::bench
