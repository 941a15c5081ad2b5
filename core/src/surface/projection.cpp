// SPDX-License-Identifier: MIT
// Makes a camera, and a frame's constants: from a vertex's numbers to the grid of samples and to depths.
#include "surface/projection.h"

#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

constexpr int kNumberBits = 14;  // fraction bits of a vertex's number
constexpr int kAxisBits = 15;    // fraction bits of a projection's axes
constexpr int kSumBits = kAxisBits + kNumberBits;
constexpr uint32_t kDepthRange = kNearDepth - kFarDepth;
constexpr int kMarginShift = 6;  // margin around the sphere, in radii: no rounding leaves the range of depths

int64_t shifted(int64_t v, int left)
{
    return left >= 0 ? v * (int64_t{1} << left) : v >> -left;
}

// Returns how far to shift right until at most `bits` bits remain.
int shift_to(uint64_t v, int bits)
{
    int shift = 0;
    while ((v >> shift) >> bits != 0) ++shift;
    return shift;
}

void set_axis(SurfaceProjection& p, int k, const Vec3q30& axis, int64_t scale)
{
    const auto scaled = [&](int32_t c) { return static_cast<int32_t>((c * scale + (1 << 29)) >> 30); };
    p.axis[k][0] = scaled(axis.x);
    p.axis[k][1] = scaled(axis.y);
    p.axis[k][2] = scaled(axis.z);
}

// z = forward·V - forward·eye.
void set_depth_axis(SurfaceProjection& p, const SurfaceCamera& camera)
{
    set_axis(p, 2, camera.forward, int64_t{1} << kAxisBits);
    p.shift[2] = shift_to(static_cast<uint64_t>(magnitude(int64_t{camera.eye.z})), 20);  // z then takes kSumBits bits
    p.depth_bits = kSumBits - p.shift[2];
    p.eye[2] = static_cast<int32_t>(-shifted(camera.eye.z, p.depth_bits - 20));
}

// x = focal·(right·V - right·eye) and y = -focal·(up·V - up·eye), to be divided by z. `spare_bits` are left out.
void set_place_axes(SurfaceProjection& p, const SurfaceCamera& camera, uint64_t focal_q12, int spare_bits)
{
    int focal_bits = 12;
    while (focal_q12 >= uint64_t{1} << kAxisBits) {
        focal_q12 >>= 1;
        --focal_bits;
    }
    while (focal_q12 < uint64_t{1} << (kAxisBits - 1)) {
        focal_q12 <<= 1;
        ++focal_bits;
    }
    const int64_t focal = static_cast<int64_t>(focal_q12);
    set_axis(p, 0, camera.right, focal);
    set_axis(p, 1, camera.up, -focal);
    const int64_t x = camera.eye.x * focal, y = camera.eye.y * focal;  // Q20, the sums have kNumberBits
    const int64_t farther = (magnitude(x) > magnitude(y) ? magnitude(x) : magnitude(y)) >> (20 - kNumberBits);
    const int shift = shift_to(static_cast<uint64_t>(farther), kSumBits) + spare_bits;
    p.shift[0] = p.shift[1] = shift;
    p.eye[0] = static_cast<int32_t>(-(x >> (20 - kNumberBits + shift)));
    p.eye[1] = static_cast<int32_t>(y >> (20 - kNumberBits + shift));
    const int place_bits = focal_bits + kNumberBits - shift;
    p.place_shift = 25 + place_bits - p.depth_bits;  // 25: 31 of the reciprocal, less 6 of the place
}

void set_places(SurfaceProjection& p, const SurfaceCamera& camera, uint32_t samples_log2)
{
    constexpr int32_t kMostShift = 30;  // bits of a place after the division, at the far end
    const uint64_t focal_q12 = uint64_t{camera.focal_q12} << samples_log2;
    set_place_axes(p, camera, focal_q12, 0);
    const int32_t spare = p.place_shift - __builtin_clz(static_cast<uint32_t>(p.far_z)) - kMostShift;
    if (spare > 0) set_place_axes(p, camera, focal_q12, spare);
    const auto q6 = [&](int32_t v_q8) { return (v_q8 * (int32_t{1} << samples_log2) + 2) >> 2; };
    p.centre_x_q6 = q6(camera.centre_x_q8);
    p.centre_y_q6 = q6(camera.centre_y_q8);
}

// The range of depths that the sphere has in front of the near plane; false if there is none.
bool set_depth_range(SurfaceProjection& p)
{
    const int32_t one = int32_t{1} << p.depth_bits, reach = one + (one >> kMarginShift);
    const int32_t near_plane = one >> kNearPlaneShift;
    p.far_z = p.eye[2] + reach;
    p.near_z = p.eye[2] - reach;
    if (p.near_z < near_plane) p.near_z = near_plane;
    return p.far_z > 2 * near_plane;
}

// A depth's number is offset·(far - z)/z, so that it is kDepthRange at the near end.
void set_depth_factor(SurfaceProjection& p)
{
    const uint32_t range = static_cast<uint32_t>(p.far_z - p.near_z);
    const uint64_t offset_q16 = (static_cast<uint64_t>(p.near_z) * kDepthRange << 16) / range;
    const int drop = shift_to(offset_q16, 16);
    p.ahead_shift = shift_to(range, 16);
    p.depth_factor = static_cast<uint32_t>(offset_q16 >> drop);
    p.depth_shift = 47 - drop - p.ahead_shift;
    p.depth_offset = static_cast<uint32_t>(offset_q16 >> 16);
}

// How long an edge is at least that is_curved finds curved. An edge e long rises by at most e/2z of the sum of its
// ends' depths, and by as much as these are rounded.
void set_straight_length(SurfaceProjection& p, uint32_t longest_edge_q6)
{
    constexpr uint64_t kMost = 1 << 14;
    const uint64_t edge = static_cast<uint64_t>(shifted(longest_edge_q6, p.depth_bits - 6)), offset = p.depth_offset;
    const uint64_t near = static_cast<uint32_t>(p.near_z), length_px = 4 * near * offset / (edge * offset + 4 * near);
    p.straight_px = static_cast<int32_t>(length_px < kMost ? length_px : kMost);
}

void set_viewer(SurfaceProjection& p, const Vec3q20& eye)
{
    const int32_t x = magnitude(eye.x), y = magnitude(eye.y), z = magnitude(eye.z);
    const int32_t most = x > y ? (x > z ? x : z) : y > z ? y : z;
    p.viewer_shift = shift_to(static_cast<uint64_t>(most) >> (20 - kNumberBits), 14);
    const int shift = 20 - kNumberBits + p.viewer_shift;
    p.viewer = {eye.x >> shift, eye.y >> shift, eye.z >> shift};
}

int32_t along(const Vec3q30& axis, const Vec3q20& eye)
{
    const int64_t sum_q50 = wide_product(axis.x, eye.x) + wide_product(axis.y, eye.y) + wide_product(axis.z, eye.z);
    return static_cast<int32_t>((sum_q50 + (int64_t{1} << 29)) >> 30);
}

}  // namespace

bool is_curved(const SurfaceFrame& frame, const SamplePoint& a, const SamplePoint& b)
{
    const uint32_t dx_q6 = static_cast<uint32_t>(magnitude(a.x_q6 - b.x_q6));
    const uint32_t dy_q6 = static_cast<uint32_t>(magnitude(a.y_q6 - b.y_q6));
    const uint32_t length = (dx_q6 > dy_q6 ? dx_q6 : dy_q6) >> (6 + frame.samples_log2);  // pixels, at most 2^16
    const uint32_t rise = a.depth > b.depth ? a.depth - b.depth : b.depth - a.depth;
    const uint64_t sum = a.depth + b.depth - 2 * kFarDepth + 2 * static_cast<uint64_t>(frame.projection.depth_offset);
    return static_cast<uint64_t>(rise) * length > 2 * sum;
}

bool set_projection(const SurfaceCamera& camera, SurfaceFrame& out)
{
    LUMI_TALLY(Work::frame, 1);
    SurfaceProjection& p = out.projection;
    set_depth_axis(p, camera);
    if (!set_depth_range(p)) return false;
    set_places(p, camera, out.samples_log2);
    set_depth_factor(p);
    set_straight_length(p, out.field.longest_edge_q6);
    set_viewer(p, camera.position);
    return true;
}

}  // namespace lumi::detail

namespace lumi
{

CameraError make_surface_camera(const Pose& pose, const Image& image, SurfaceCamera& out)
{
    if (const CameraError error = detail::check_view(pose, image); error != CameraError::none) return error;
    out.position = pose.eye;
    out.eye = {detail::along(pose.right, pose.eye), detail::along(pose.up, pose.eye),
               detail::along(pose.forward, pose.eye)};
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
