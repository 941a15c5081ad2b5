// SPDX-License-Identifier: MIT
#include "lumi/chord/camera.h"

#include "lumi/chord/detail/stepping/outline.h"
#include "lumi/detail/math.h"

namespace lumi
{
namespace
{

using namespace detail;

// A vector of Q46 components: viewing vectors before they are scaled to the image's corners, up to 2^6 long.
struct Vec3q46 {
    int64_t x, y, z;
};

Vec3q46 scaled(const Vec3q30& v, int64_t factor_q46)
{
    return {multiply_shift(factor_q46, v.x, 30), multiply_shift(factor_q46, v.y, 30),
            multiply_shift(factor_q46, v.z, 30)};
}

Vec3q46 operator+(const Vec3q46& a, const Vec3q46& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

int64_t dot_q46(const Vec3q46& a, const Vec3q30& unit)
{
    return multiply_shift(a.x, unit.x, 30) + multiply_shift(a.y, unit.y, 30) + multiply_shift(a.z, unit.z, 30);
}

int32_t unit_component(int32_t eye_q20, const ReciprocalRoot& root)
{
    const int64_t product = wide_product(eye_q20, static_cast<int32_t>(root.mantissa >> 1));
    const int shift = root.exponent - 31;  // 20 at e = 1 .. 31 at e = 2047
    return static_cast<int32_t>((product + (int64_t{1} << (shift - 1))) >> shift);
}

// The viewing vectors of an image, scaled so that none is longer than 1.
struct ViewVectors {
    Vec3q46 first;  // that of pixel (0, 0)
    Vec3q46 step_x, step_y;
};

// Returns the distance from the optical axis to the farther edge of the image, in half pixels, Q8.
int64_t reach_q8(int32_t side_px, int32_t shift_q8)
{
    return static_cast<int64_t>(side_px) * 256 + 2 * (shift_q8 < 0 ? -static_cast<int64_t>(shift_q8) : shift_q8);
}

ViewVectors view_vectors(const Pose& pose, const Image& image)
{
    const SinCos half_fov = sin_cos(image.fov_turns32 / 2);
    const int64_t tangent_q33 = (static_cast<int64_t>(half_fov.sin_q30) << 33) / half_fov.cos_q30;
    const int32_t longer_px = image.width_px > image.height_px ? image.width_px : image.height_px;
    const int64_t half_pixel_q46 = (tangent_q33 << 13) / longer_px;

    const int64_t reach_x_q28 = (half_pixel_q46 * reach_q8(image.width_px, image.shift_x_q8)) >> 26;
    const int64_t reach_y_q28 = (half_pixel_q46 * reach_q8(image.height_px, image.shift_y_q8)) >> 26;
    const uint64_t corner2_q56 = (uint64_t{1} << 56) + static_cast<uint64_t>(reach_x_q28 * reach_x_q28) +
                                 static_cast<uint64_t>(reach_y_q28 * reach_y_q28);
    const ReciprocalRoot root = reciprocal_root(corner2_q56);  // 2^-28 / corner
    const int32_t scale_q30 =
        static_cast<int32_t>((static_cast<uint64_t>(root.mantissa) << 28) >> (root.exponent - 30)) - 1;

    const int64_t pixel_q46 = 2 * multiply_shift(half_pixel_q46, scale_q30, 30);
    const int64_t x0_q8 = 128 - static_cast<int64_t>(image.width_px) * 128 - image.shift_x_q8;
    const int64_t y0_q8 = 128 - static_cast<int64_t>(image.height_px) * 128 - image.shift_y_q8;
    const Vec3q46 axis = scaled(pose.forward, static_cast<int64_t>(scale_q30) << 16);
    return {axis + scaled(pose.right, (pixel_q46 * x0_q8) >> 8) + scaled(pose.up, -(pixel_q46 * y0_q8) >> 8),
            scaled(pose.right, pixel_q46), scaled(pose.up, -pixel_q46)};
}

// Splits a viewing vector into m = -ê·D and P = e·(D + m·ê), both Q40.
struct SplitQ40 {
    int64_t facing, offset[3];
};

SplitQ40 split(const Vec3q46& d, const Vec3q30& eye_direction, int32_t distance_q20)
{
    const int64_t m_q46 = -dot_q46(d, eye_direction);
    const Vec3q46 p = d + scaled(eye_direction, m_q46);
    const auto times_distance = [&](int64_t c) { return multiply_shift(c, distance_q20, 26); };
    return {m_q46 >> 6, {times_distance(p.x), times_distance(p.y), times_distance(p.z)}};
}

}  // namespace

void Camera::set_eye(const Vec3q20& eye, uint64_t distance2_q40)
{
    const ReciprocalRoot root = reciprocal_root(distance2_q40);  // 2^-20 / e
    eye_direction_ = {unit_component(eye.x, root), unit_component(eye.y, root), unit_component(eye.z, root)};
    const uint64_t inverse = (static_cast<uint64_t>(root.mantissa) << 20) >> (root.exponent - 30);
    inverse_distance_q30_ = inverse > static_cast<uint64_t>(kOneQ30) ? kOneQ30 : static_cast<int32_t>(inverse);
    perpendicular_q30_ = kOneQ30 - mul_q30(inverse_distance_q30_, inverse_distance_q30_);
}

void Camera::set_view(const Pose& pose, const Image& image)
{
    const ViewVectors view = view_vectors(pose, image);
    // e consistent with the rounded 1/e, so that q = m² + |P|²/e² stays |D|².
    const uint64_t distance = (uint64_t{1} << 50) / static_cast<uint32_t>(inverse_distance_q30_);
    const int32_t distance_q20 = static_cast<int32_t>(distance);
    const SplitQ40 first = split(view.first, eye_direction_, distance_q20);
    const SplitQ40 step_x = split(view.step_x, eye_direction_, distance_q20);
    const SplitQ40 step_y = split(view.step_y, eye_direction_, distance_q20);
    facing_ = {first.facing, step_x.facing, step_y.facing};
    for (int k = 0; k < 3; ++k) offset_[k] = {first.offset[k], step_x.offset[k], step_y.offset[k]};
}

CameraError make_camera(const Pose& pose, const Image& image, Camera& out)
{
    if (const CameraError error = check_view(pose, image); error != CameraError::none) return error;
    out.set_eye(pose.eye, length2_q40(pose.eye));
    out.set_view(pose, image);
    out.width_px_ = image.width_px;
    out.height_px_ = image.height_px;
    out.outline_ = make_outline(out);
    return CameraError::none;
}

}  // namespace lumi
