// SPDX-License-Identifier: MIT
// Perspective cameras look at the unit sphere, in integers.
//
// Frame: the sphere is centred at the origin with radius 1; z is up (the lattice's north pole). Lengths are in units of
// the radius. Axes: right = forward × up. Pixels count to the right (x) and down (y); their centres lie at +1/2. The
// field of view spans the LONGER side of the image.
#pragma once
#pragma GCC system_header

#include "lumi/fixed.h"

namespace lumi
{

enum class [[nodiscard]] CameraError : uint8_t{
    none = 0,
    eye_inside_sphere,     // |eye| < 1 - kEyeTolerance: a field holds no radiance inside its sphere
    eye_too_far,           // |eye| > 2047·(1 + kEyeTolerance)
    field_of_view_range,   // outside kMinFov .. kMaxFov
    image_size_range,      // a side is < 1 or > kMaxImageSide, or the shift is more than a side
    axes_not_orthonormal,  // right, up, forward differ from an orthonormal basis by more than 2^-12
};

const char* describe(CameraError error);

inline constexpr int32_t kMaxEyeDistanceQ20 = 2047 * kOneQ20;
// An eye may lie by this share of its distance, 1/131072, beyond either end, 1 and 2047 radii: a pose's rounding, here
// or from single precision, moves it by less than an eighth of that. Chord fields are drawn as from 1 radius then.
inline constexpr int kEyeToleranceShift = 17;
inline constexpr uint32_t kMinFovTurns32 = 11930464;    // 1 degree
inline constexpr uint32_t kMaxFovTurns32 = 1431655766;  // 120 degrees
inline constexpr int32_t kMaxImageSide = 8192;

// Where the eye is and how it is turned. right, up, forward are orthonormal; forward points into the scene.
struct Pose {
    Vec3q20 eye;
    Vec3q30 right, up, forward;
};

// This is an image of width × height pixels. The optical axis meets it at its centre, moved by `shift` pixels (Q8) to
// the right and down: lens shift for tiled walls and off-axis stereo.
struct Image {
    int32_t width_px, height_px;
    uint32_t fov_turns32;
    int32_t shift_x_q8 = 0, shift_y_q8 = 0;
};

// Moves a pose by `offset` along its own right axis: a stereo pair is moved_right(p, -d/2), moved_right(p,
// +d/2), with parallel axes as a head-mounted display needs. An eye that leaves the range of numbers stops at its end,
// which make_camera refuses.
Pose moved_right(const Pose& pose, int32_t offset_q20);

// Turns the picture clockwise, for displays that are mounted askew or upside down: after a quarter turn, what was up is
// at the right. Quarter turns are exact, and no turn changes no bit; others round each number to 2^-30.
//
//     view.look(rolled(pose_of(orbit), degrees(90)), view.fov_of(orbit));
Pose rolled(const Pose& pose, uint32_t roll_turns32);

}  // namespace lumi

namespace lumi::detail
{

// Places the eye on a sphere of radius `distance` around the origin, looking at the origin, z up in the picture.
// azimuth 0 looks from +x, a quarter turn from +y; elevation from -1/4 to 1/4 turn (as a signed fraction).
Pose orbit(uint32_t azimuth_turns32, int32_t elevation_turns32, int32_t distance_q20);

// Tells whether a camera can have this view.
CameraError check_view(const Pose& pose, const Image& image);

}  // namespace lumi::detail
