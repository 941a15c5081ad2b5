// SPDX-License-Identifier: MIT
// Perspective cameras around the unit sphere, in integers.
//
// Frame: the sphere is centred at the origin with radius 1; z is up (the lattice's north pole). Lengths are in units of
// the radius. Axes: right = forward × up. Pixels count to the right (x) and down (y); their centres lie at +1/2. The
// field of view spans the LONGER side of the image.
#pragma once

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

// An image of width × height pixels. The optical axis meets it at its centre, moved by `shift` pixels (Q8) to the right
// and down: lens shift for tiled walls and off-axis stereo.
struct Image {
    int32_t width_px, height_px;
    uint32_t fov_turns32;
    int32_t shift_x_q8 = 0, shift_y_q8 = 0;
};

// An eye on a sphere of radius `distance` around the origin, looking at the origin, z up in the picture.
// azimuth 0 looks from +x, a quarter turn from +y; elevation from -1/4 to 1/4 turn (as a signed fraction).
Pose orbit(uint32_t azimuth_turns32, int32_t elevation_turns32, int32_t distance_q20);

// The same pose moved by `offset` along its own right axis: a stereo pair is moved_right(p, -d/2), moved_right(p,
// +d/2), with parallel axes as a head-mounted display needs. An eye that leaves the range of numbers stops at its end,
// which make_camera refuses.
Pose moved_right(const Pose& pose, int32_t offset_q20);

// A quantity that is affine in the pixel, Q40.
struct AffineQ40 {
    int64_t at_first;  // at the centre of pixel (0, 0)
    int64_t step_x, step_y;

    int64_t at(int32_t x, int32_t y) const { return at_first + x * step_x + y * step_y; }
};

// The sphere's outline as a quadratic polynomial of the pixel, f = constant + x·(x1 + x·x2 + y·xy) + y·(y1 + y·y2),
// scaled so that 64 bits hold it at every pixel of the image: see outline.h.
struct OutlineQuadratic {
    int64_t constant, x1, y1, x2, xy, y2;

    int64_t at(int32_t x, int32_t y) const { return constant + x * (x1 + x * x2 + y * xy) + y * (y1 + y * y2); }
};

// What the renderer needs of a camera. Every quantity is scaled by one positive factor so that a pixel's viewing vector
// D is at most 1 long. With ê the unit vector towards the eye, e its distance, m = -ê·D and P = e·(D + m·ê), the ray
// hits the sphere where |P|² + s² = q with q = m² + |P|²/e² and s² = m² - (1 - 1/e²)|P|², at
//     h = ê·(|P|²/e ± s·m)/q + P·(m ∓ s/e)/q      (upper sign: front, lower sign: back).
// No difference of large numbers appears, from an eye on the sphere (e = 1) to one at infinity. m and P are affine in
// the pixel.
//
// Ranges and errors: ê and 1/e to 2^-28. m, P and their steps are Q40, below 2^12 for rays that miss and at most 1
// where one hits. q lies between 1/26 (120 degrees, the axis near a corner of the image) and 1.
//
// Its parts belong together, so nothing changes them but make_camera and interlaced_half.
class Camera
{
public:
    const Vec3q30& eye_direction() const { return eye_direction_; }         // ê
    int32_t inverse_distance_q30() const { return inverse_distance_q30_; }  // 1/e in (0, 1]
    int32_t perpendicular_q30() const { return perpendicular_q30_; }        // 1 - 1/e² in [0, 1)
    const AffineQ40& facing() const { return facing_; }                     // m
    const AffineQ40 (&offset() const)[3] { return offset_; }                // P (x, y, z)
    const OutlineQuadratic& outline() const { return outline_; }
    int32_t width_px() const { return width_px_; }
    int32_t height_px() const { return height_px_; }

private:
    friend CameraError make_camera(const Pose& pose, const Image& image, Camera& out);
    friend Camera interlaced_half(const Camera& camera, int32_t parity);

    void set_eye(const Vec3q20& eye, uint64_t distance2_q40);
    void set_view(const Pose& pose, const Image& image);

    Vec3q30 eye_direction_{};
    int32_t inverse_distance_q30_ = 0;
    int32_t perpendicular_q30_ = 0;
    AffineQ40 facing_{};
    AffineQ40 offset_[3]{};
    OutlineQuadratic outline_{};
    int32_t width_px_ = 0, height_px_ = 0;
};

// What is wrong with a view, if anything.
CameraError check_view(const Pose& pose, const Image& image);

// Fills `out`, which stays untouched on failure.
CameraError make_camera(const Pose& pose, const Image& image, Camera& out);

// The camera whose scanlines are every other one of `camera`'s image: scanline y is that of 2·y + parity. Its stripes
// go to every other scanline of the display. Where the image is one scanline high, parity 1 has none: nothing is drawn.
Camera interlaced_half(const Camera& camera, int32_t parity);

}  // namespace lumi
