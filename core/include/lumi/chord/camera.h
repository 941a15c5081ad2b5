// SPDX-License-Identifier: MIT
// The camera of chord fields tells where rays meet the sphere, in quantities that are affine in the pixel.
// lumi/camera.h states frame and units.
#pragma once
#pragma GCC system_header

#include "lumi/camera.h"

namespace lumi::detail
{

// The tangent rule: a ray is discarded whose half chord is shorter than 1/64 of the radius. It crosses only a sliver of
// the sphere's rim (the disc shrinks by 0.012 %), and what is left keeps sqrt(s²) well conditioned.
inline constexpr int kTangentShift = 12;  // s² >= q / 2^12

// This quantity is affine in the pixel, Q40.
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

}  // namespace lumi::detail

namespace lumi
{

// Holds the numbers that the renderer needs of a camera. Every quantity is scaled by one positive factor so that a
// pixel's viewing vector D is at most 1 long. With ê the unit vector towards the eye, e its distance, m = -ê·D and P =
// e·(D + m·ê), the ray hits the sphere where |P|² + s² = q with q = m² + |P|²/e² and s² = m² - (1 - 1/e²)|P|², at
//     h = ê·(|P|²/e ± s·m)/q + P·(m ∓ s/e)/q      (upper sign: front, lower sign: back).
// No difference of large numbers appears, from an eye on the sphere (e = 1) to one at infinity. m and P are affine in
// the pixel.
//
// Ranges and errors: ê and 1/e to 2^-28. m, P and their steps are Q40, below 2^12 for rays that miss and at most 1
// where one hits. q lies between 1/26 (120 degrees, the axis near a corner of the image) and 1.
//
// Its parts belong together, so nothing changes them but make_camera.
class Camera
{
public:
    const Vec3q30& eye_direction() const { return eye_direction_; }         // ê
    int32_t inverse_distance_q30() const { return inverse_distance_q30_; }  // 1/e in (0, 1]
    int32_t perpendicular_q30() const { return perpendicular_q30_; }        // 1 - 1/e² in [0, 1)
    const detail::AffineQ40& facing() const { return facing_; }             // m
    const detail::AffineQ40 (&offset() const)[3] { return offset_; }        // P (x, y, z)
    const detail::OutlineQuadratic& outline() const { return outline_; }
    int32_t width_px() const { return width_px_; }
    int32_t height_px() const { return height_px_; }

private:
    friend CameraError make_camera(const Pose& pose, const Image& image, Camera& out);

    void set_eye(const Vec3q20& eye, uint64_t distance2_q40);
    void set_view(const Pose& pose, const Image& image);

    Vec3q30 eye_direction_{};
    int32_t inverse_distance_q30_ = 0;
    int32_t perpendicular_q30_ = 0;
    detail::AffineQ40 facing_{};
    detail::AffineQ40 offset_[3]{};
    detail::OutlineQuadratic outline_{};
    int32_t width_px_ = 0, height_px_ = 0;
};

// Fills `out`, which stays untouched on failure.
CameraError make_camera(const Pose& pose, const Image& image, Camera& out);

}  // namespace lumi
