// SPDX-License-Identifier: MIT
#include "lumi/camera.h"

#include "lumi/detail/math.h"

namespace lumi
{
namespace
{

using namespace detail;

// Whether the product of two vectors in unit range is `whole`, 0 or 1: up to 3, which Q30 does not hold.
bool has_product(const Vec3q30& a, const Vec3q30& b, int32_t whole)
{
    constexpr int64_t kOneQ60 = int64_t{1} << 60, kToleranceQ60 = kOneQ60 >> 12;
    const int64_t difference = dot_q60(a, b) - whole * kOneQ60;
    return -kToleranceQ60 <= difference && difference <= kToleranceQ60;
}

bool in_unit_range(const Vec3q30& v)
{
    constexpr int32_t kLimit = kOneQ30 + (kOneQ30 >> 12);
    const auto inside = [](int32_t c) { return -kLimit <= c && c <= kLimit; };
    return inside(v.x) && inside(v.y) && inside(v.z);
}

bool is_orthonormal(const Pose& p)
{
    return in_unit_range(p.right) && in_unit_range(p.up) && in_unit_range(p.forward) &&
           has_product(p.right, p.right, 1) && has_product(p.up, p.up, 1) && has_product(p.forward, p.forward, 1) &&
           has_product(p.right, p.up, 0) && has_product(p.right, p.forward, 0) && has_product(p.up, p.forward, 0);
}

bool in_side_range(int32_t side_px)
{
    return side_px >= 1 && side_px <= kMaxImageSide;
}

bool in_shift_range(int32_t shift_q8, int32_t side_px)
{
    return -side_px * 256 <= shift_q8 && shift_q8 <= side_px * 256;
}

CameraError check_image(const Image& image)
{
    if (image.fov_turns32 < kMinFovTurns32 || image.fov_turns32 > kMaxFovTurns32)
        return CameraError::field_of_view_range;
    const bool ok = in_side_range(image.width_px) && in_side_range(image.height_px) &&
                    in_shift_range(image.shift_x_q8, image.width_px) &&
                    in_shift_range(image.shift_y_q8, image.height_px);
    return ok ? CameraError::none : CameraError::image_size_range;
}

CameraError check_eye(const Vec3q20& eye)
{
    constexpr int32_t kNearest = kOneQ20 - (kOneQ20 >> kEyeToleranceShift);
    constexpr int32_t kFarthest = kMaxEyeDistanceQ20 + (kMaxEyeDistanceQ20 >> kEyeToleranceShift);
    const auto square = [](int32_t c) { return static_cast<uint64_t>(wide_product(c, c)); };
    const uint64_t distance2_q40 = length2_q40(eye);
    if (distance2_q40 > square(kFarthest)) return CameraError::eye_too_far;
    return distance2_q40 < square(kNearest) ? CameraError::eye_inside_sphere : CameraError::none;
}

}  // namespace

Pose detail::orbit(uint32_t azimuth_turns32, int32_t elevation_turns32, int32_t distance_q20)
{
    const SinCos a = sin_cos(azimuth_turns32);
    const SinCos e = sin_cos(static_cast<uint32_t>(elevation_turns32));
    const Vec3q30 out = {mul_q30(e.cos_q30, a.cos_q30), mul_q30(e.cos_q30, a.sin_q30), e.sin_q30};
    return {{mul_q30(out.x, distance_q20), mul_q30(out.y, distance_q20), mul_q30(out.z, distance_q20)},
            {-a.sin_q30, a.cos_q30, 0},
            {-mul_q30(e.sin_q30, a.cos_q30), -mul_q30(e.sin_q30, a.sin_q30), e.cos_q30},
            {-out.x, -out.y, -out.z}};
}

Pose moved_right(const Pose& pose, int32_t offset_q20)
{
    const auto moved = [&](int32_t eye_q20, int32_t right_q30) {
        const int64_t sum = static_cast<int64_t>(eye_q20) + ((wide_product(right_q30, offset_q20) + kOneQ30 / 2) >> 30);
        return static_cast<int32_t>(sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : sum);
    };
    Pose result = pose;
    result.eye = {moved(pose.eye.x, pose.right.x), moved(pose.eye.y, pose.right.y), moved(pose.eye.z, pose.right.z)};
    return result;
}

Pose rolled(const Pose& pose, uint32_t roll_turns32)
{
    const SinCos roll = sin_cos(roll_turns32);
    const auto turned = [](const Vec3q30& a, int32_t share_a, const Vec3q30& b, int32_t share_b) {
        const auto sum = [&](int32_t p, int32_t q) {
            return q60_to_q30(wide_product(p, share_a) + wide_product(q, share_b));
        };
        return Vec3q30{sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)};
    };
    Pose result = pose;
    result.right = turned(pose.right, roll.cos_q30, pose.up, roll.sin_q30);
    result.up = turned(pose.up, roll.cos_q30, pose.right, -roll.sin_q30);
    return result;
}

CameraError detail::check_view(const Pose& pose, const Image& image)
{
    if (const CameraError error = check_eye(pose.eye); error != CameraError::none) return error;
    if (const CameraError error = check_image(image); error != CameraError::none) return error;
    return is_orthonormal(pose) ? CameraError::none : CameraError::axes_not_orthonormal;
}

const char* describe(CameraError error)
{
    switch (error) {
        case CameraError::none:
            return "no error";
        case CameraError::eye_inside_sphere:
            return "the eye is inside the bounding sphere: move it to a distance of 1 radius or more";
        case CameraError::eye_too_far:
            return "the eye is too far away: at most 2047 radii";
        case CameraError::field_of_view_range:
            return "the field of view is outside 1 to 120 degrees";
        case CameraError::image_size_range:
            return "an image side is outside 1 to 8192 pixels, or the shift is larger than it";
        case CameraError::axes_not_orthonormal:
            return "the camera's axes are not orthonormal";
    }
    return "unknown error";
}

}  // namespace lumi
