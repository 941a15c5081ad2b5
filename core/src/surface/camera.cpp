// SPDX-License-Identifier: MIT
#include "lumi/detail/math.h"
#include "lumi/surface/frame.h"

namespace lumi
{
namespace
{

using namespace detail;

int32_t along(const Vec3q30& axis, const Vec3q20& eye)
{
    const int64_t sum_q50 = wide_product(axis.x, eye.x) + wide_product(axis.y, eye.y) + wide_product(axis.z, eye.z);
    return static_cast<int32_t>((sum_q50 + (int64_t{1} << 29)) >> 30);
}

}  // namespace

CameraError make_surface_camera(const Pose& pose, const Image& image, SurfaceCamera& out)
{
    if (const CameraError error = check_view(pose, image); error != CameraError::none) return error;
    out.position = pose.eye;
    out.eye = {along(pose.right, pose.eye), along(pose.up, pose.eye), along(pose.forward, pose.eye)};
    out.right = pose.right;
    out.up = pose.up;
    out.forward = pose.forward;
    out.width_px = image.width_px;
    out.height_px = image.height_px;
    const SinCos half_fov = sin_cos(image.fov_turns32 / 2);
    const int32_t longer_px = image.width_px > image.height_px ? image.width_px : image.height_px;
    const int64_t over = static_cast<int64_t>(longer_px) * half_fov.cos_q30;
    out.focal_q12 = static_cast<uint32_t>((over << 11) / half_fov.sin_q30);
    out.centre_x_q8 = image.width_px * 128 + image.shift_x_q8;
    out.centre_y_q8 = image.height_px * 128 + image.shift_y_q8;
    return CameraError::none;
}

}  // namespace lumi
