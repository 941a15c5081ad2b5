// SPDX-License-Identifier: MIT
// The bench draws these: three views of 240 × 240 pixels, shared by the firmware that is counted and the host that
// judges the pictures.
#pragma once

#include "lumi/background.h"
#include "lumi/chord/camera.h"

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

// Cannot fail for kViews.
inline CameraError make_view_camera(const View& view, Camera& out)
{
    return make_camera(view_pose(view), view_image(view), out);
}

}  // namespace lumi::bench
