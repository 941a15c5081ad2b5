// SPDX-License-Identifier: MIT
// The bench draws these: three views of 240 × 240 pixels, shared by the firmware that is counted and the host that
// judges the pictures.
#pragma once

#include "lumi/attitude.h"
#include "lumi/background.h"
#include "lumi/chord/camera.h"
#include "lumi/orbit.h"

namespace lumi::bench
{

inline constexpr int32_t kSidePx = 240;
// Most products show such a plain colour behind an object.
inline constexpr OverBlack kBackground;
inline constexpr Rgb8 kBackgroundColour = {0, 0, 0};

struct View {
    const char* name;
    uint32_t azimuth_turns32;
    int32_t elevation_turns32;
    int32_t distance_q20;
    uint32_t fov_turns32;
};

inline constexpr uint32_t kDegree = 11930465;  // 2^32 / 360

// From three radii, the sphere's disc is 232 of 240 pixels wide: tan(fov/2) = 240/232 · tan(asin(1/3)).
inline constexpr int32_t kFarQ20 = 3 * kOneQ20;
inline constexpr uint32_t kFillingFov = 479355000;  // 40.18 degrees

// From 1.3 radii the sphere reaches beyond the picture on every side.
inline constexpr int32_t kCloseQ20 = 13 * kOneQ20 / 10;
inline constexpr uint32_t kCloseFov = 60 * kDegree;

inline constexpr View kViews[] = {
    {"generic", 37 * kDegree, 23 * static_cast<int32_t>(kDegree), kFarQ20, kFillingFov},
    {"pole", 61 * kDegree, 1 << 30, kFarQ20, kFillingFov},
    {"close", 119 * kDegree, 12 * static_cast<int32_t>(kDegree), kCloseQ20, kCloseFov},
};

inline Pose view_pose(const View& view)
{
    return detail::orbit(view.azimuth_turns32, view.elevation_turns32, view.distance_q20);
}

inline Image view_image(const View& view)
{
    return {kSidePx, kSidePx, view.fov_turns32};
}

// It cannot fail for kViews.
inline CameraError make_view_camera(const View& view, Camera& out)
{
    return make_camera(view_pose(view), view_image(view), out);
}

// Poses all around the sphere, near and far and rolled, for the worst case of a frame: both poles in four rolls, then
// turns at random. The sphere fills the image from every distance.
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
