// SPDX-License-Identifier: MIT
// Where people say the eye is: degrees, radii, and the field of view that shows the whole sphere.
//
//     Orbit orbit = {degrees(30), degrees(20), radii(3)};
//     orbit.azimuth_turns32 += degrees(2);  // angles wrap
#pragma once
#pragma GCC system_header

#include "lumi/camera.h"

namespace lumi
{

// An angle in whole degrees, of either sign, to the nearest 2^-32 turn. |whole_degrees| <= 1,000,000. Parts of a degree
// are quotients: degrees(45) / 2.
constexpr uint32_t degrees(int32_t whole_degrees)
{
    constexpr int64_t kTurn = int64_t{1} << 32, kTurns = 4096;  // added: the quotient of a negative sum rounds up
    return static_cast<uint32_t>((whole_degrees * kTurn + 360 * kTurn * kTurns + 180) / 360);
}

// A length in radii of the sphere, up to 2047. radii(5) / 2 is two and a half.
constexpr int32_t radii(int32_t whole_radii)
{
    return whole_radii * kOneQ20;
}

// In place of a field of view: the one in which the sphere fills the image, see fit_sphere.
inline constexpr uint32_t kFitSphere = 0;

inline constexpr uint32_t kNoZoom = 1u << 16;

// An eye that looks at the centre of the sphere, z up in the picture. With a fitted sphere the distance changes the
// perspective alone; zoom makes the object larger.
struct Orbit {
    uint32_t azimuth_turns32 = 0;    // 0 looks from +x, a quarter turn from +y
    uint32_t elevation_turns32 = 0;  // -1/4 to 1/4 turn: degrees(-20) is below
    int32_t distance_q20 = 3 * kOneQ20;
    uint32_t fov_turns32 = kFitSphere;
    uint32_t zoom_q16 = kNoZoom;  // 2 * kNoZoom shows everything twice as large, as far as a field of view of 1 to 120
                                  // degrees does; 0 counts as kNoZoom
};

// The field of view over the image's longer side in which the sphere, seen from so far, fills the shorter side but for
// a margin of 6 %: what `lumi render` takes without --fov. Within what a camera takes: 1 to 120 degrees, the latter
// also for an eye inside the sphere. Precondition: sides from 1 to kMaxImageSide, a distance of at most
// kMaxEyeDistanceQ20.
uint32_t fit_sphere(int32_t width_px, int32_t height_px, int32_t distance_q20);

// Pose and image of an orbit, for make_camera and make_surface_camera, which check them.
inline Pose pose_of(const Orbit& o)
{
    return detail::orbit(o.azimuth_turns32, static_cast<int32_t>(o.elevation_turns32), o.distance_q20);
}
Image image_of(const Orbit& orbit, int32_t width_px, int32_t height_px);

// The field of view that shows everything so many times as large, within what a camera takes. Precondition: a field of
// view that a camera takes.
uint32_t zoomed(uint32_t fov_turns32, uint32_t zoom_q16);

}  // namespace lumi
