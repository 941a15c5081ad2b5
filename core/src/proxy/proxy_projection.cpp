// SPDX-License-Identifier: MIT
// A frame's constants: from the mesh's numbers to the sample grid, to depths and back to points.
#include "proxy/proxy_projection.h"

#include "proxy/proxy_points.h"

namespace lumi::proxy_math
{
namespace
{

constexpr int kAxisBits = 18;    // fraction bits of a projection's axes
constexpr int kNumberBits = 11;  // a vertex's number n stands for n/2^11
constexpr int kSumBits = kAxisBits + kNumberBits;
constexpr int32_t kHalfRadius = int32_t{1} << (kSumBits - 1);  // as a sum
constexpr uint32_t kDepthRange = kNearDepth - kFarDepth;

int64_t shifted(int64_t v, int left)
{
    return left >= 0 ? v * (int64_t{1} << left) : v >> -left;
}

// How far to shift right until fewer than `bits` bits remain.
int shift_to(uint64_t v, int bits)
{
    int shift = 0;
    while ((v >> shift) >> bits != 0) ++shift;
    return shift;
}

void set_axis(ProxyProjection& p, int k, const Vec3q30& axis, int64_t scale_q18)
{
    const auto scaled = [&](int32_t c) { return static_cast<int32_t>((c * scale_q18 + (1 << 29)) >> 30); };
    p.axis[k][0] = scaled(axis.x);
    p.axis[k][1] = scaled(axis.y);
    p.axis[k][2] = scaled(axis.z);
    p.base[k] = static_cast<int32_t>(
        2048u * static_cast<uint32_t>(p.axis[k][0] + p.axis[k][1] + p.axis[k][2]));  // modulo 2^32, as the sums
}

// z = forward·V - forward·eye.
void set_depth_axis(ProxyProjection& p, const GuidedCamera& camera)
{
    set_axis(p, 2, camera.forward, int64_t{1} << kAxisBits);
    p.shift[2] =
        shift_to(static_cast<uint64_t>(magnitude(int64_t{camera.eye.z})), 20);  // |eye| then takes kSumBits bits
    p.depth_bits = kSumBits - p.shift[2];
    p.eye[2] = static_cast<int32_t>(-shifted(camera.eye.z, p.depth_bits - 20));
}

// x = focal·(right·V - right·eye) and y = -focal·(up·V - up·eye), to be divided by z. `spare_bits` are left out.
void set_place_axes(ProxyProjection& p, const GuidedCamera& camera, uint64_t focal_q12, int spare_bits)
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
    p.place_bits = focal_bits + kNumberBits - shift;
    p.place_shift = 25 + p.place_bits - p.depth_bits;  // 25: 31 of the reciprocal, less 6 of the place
}

struct SumRange {
    int32_t least, most;
};

SumRange depth_sums(const ProxyProjection& p, const ProxyMesh& mesh)
{
    SumRange range = {INT32_MAX, INT32_MIN};
    for (uint32_t k = 0; k < mesh.vertex_count; ++k) {
        const int32_t sum = axis_sum(p, 2, triple12(mesh.vertices, k));
        if (sum < range.least) range.least = sum;
        if (sum > range.most) range.most = sum;
    }
    return range;
}

// The range of depths that the mesh has in front of the near plane; false if there is none.
bool set_depth_range(ProxyProjection& p, const ProxyMesh& mesh)
{
    if (mesh.vertex_count == 0) return false;
    const SumRange sums = depth_sums(p, mesh);
    const auto depth_of = [&](int32_t sum) { return (sum >> p.shift[2]) + p.eye[2]; };
    const int32_t near_plane = int32_t{1} << (p.depth_bits - kNearPlaneShift);
    if (depth_of(sums.most) <= near_plane) return false;
    p.near_z = depth_of(sums.least) > near_plane ? depth_of(sums.least) : near_plane;
    p.far_sum = sums.most;
    // A range of half a radius at least: flat meshes need no finer steps.
    const int32_t missing = (kHalfRadius >> p.shift[2]) - (depth_of(p.far_sum) - p.near_z);
    if (missing > 0) p.far_sum += missing * (int32_t{1} << p.shift[2]);
    p.far_z = depth_of(p.far_sum);
    return true;
}

// near·range/(far - near) in Q16: what a depth's number misses to be proportional to 1/z.
uint64_t depth_offset_q16(const ProxyProjection& p)
{
    return (static_cast<uint64_t>(p.near_z) * kDepthRange << 16) / static_cast<uint32_t>(p.far_z - p.near_z);
}

void set_depth_factor(ProxyProjection& p)
{
    // Two bits of room for the last bit's rounding.
    p.ahead_shift = shift_to(static_cast<uint64_t>(p.far_z - p.near_z + 2) << p.shift[2], 16);
    const uint64_t offset_q16 = depth_offset_q16(p);
    const int drop = shift_to(offset_q16, 16);
    p.depth_factor = static_cast<uint32_t>(offset_q16 >> drop);
    p.depth_shift = 16 - drop - p.ahead_shift - p.depth_bits + kSumBits + 31;
}

void set_depths(const ProxyProjection& p, ProxyDepths& depths)
{
    const uint64_t offset_q16 = depth_offset_q16(p);
    const uint64_t end_q16 = offset_q16 + (uint64_t{kDepthRange} << 16);
    depths.scale = 16 - shift_to(end_q16, 31);
    depths.offset = static_cast<uint32_t>(offset_q16 >> (16 - depths.scale));
    const int drop = shift_to(static_cast<uint64_t>(p.far_z), 16);
    depths.factor = static_cast<uint32_t>(p.far_z >> drop);
    depths.shift = p.depth_bits - drop + 2 - depths.scale;
    for (uint32_t k = 0; k < kDepthSteps; ++k) {
        const int32_t back = exact_back_q13(depths, static_cast<int32_t>(256 * k));
        depths.back_q13[k] = static_cast<uint16_t>(back);
    }
    // 1/z from the near end's sixth on: the second difference of a step is then below 2^-12 of the range.
    const int64_t sixth = static_cast<int64_t>((end_q16 / 6 >> 16)) - static_cast<int64_t>(offset_q16 >> 16);
    depths.exact_below = static_cast<uint16_t>(sixth > 0 ? static_cast<int64_t>(kFarDepth) + sixth : 0);
    const uint64_t far_q13 = static_cast<uint64_t>(shifted(p.far_z, 13 - p.depth_bits));
    depths.same_surface = static_cast<uint16_t>((kSameSurfaceQ13 * offset_q16 / far_q13) >> 16);
}

// A tangent and the place at the far end's depth, as functions of a pixel's column or row.
struct Line {
    int32_t tangent_q26, tangent_step_q26, place_q26, place_step_q26;
};

Line line(uint32_t focal_q12, int32_t centre_q8, const ProxyProjection& p)
{
    const int64_t first_q8 = 128 - centre_q8;
    const int64_t focal = focal_q12;
    const int64_t step_q38 = shifted(p.far_z, 50 - p.depth_bits) / focal;  // far/focal
    const auto wrapped = [](int64_t v) { return static_cast<int32_t>(static_cast<uint32_t>(v)); };
    return {wrapped(first_q8 * (int64_t{1} << 30) / focal), wrapped((int64_t{1} << 38) / focal),
            wrapped(first_q8 * step_q38 >> 20), wrapped(step_q38 >> 12)};
}

void set_rays(const ProxyProjection& p, const GuidedCamera& camera, ProxyRays& rays, ProxyRowRays& rows)
{
    const auto q26 = [](int32_t v_q20) { return static_cast<int32_t>(static_cast<uint32_t>(v_q20) << 6); };
    const Line x = line(camera.focal_q12, camera.centre_x_q8, p);
    rays.tangent_q26 = x.tangent_q26;
    rays.tangent_step_q26 = x.tangent_step_q26;
    rays.across_q26 = wrapped_sum(q26(camera.eye.x), x.place_q26);
    rays.across_step_q26 = x.place_step_q26;
    const Line y = line(camera.focal_q12, camera.centre_y_q8, p);
    rows.down_q26 = y.tangent_q26;
    rows.down_step_q26 = y.tangent_step_q26;
    rows.lift_q26 = wrapped_sum(q26(camera.eye.y), wrapped_product(y.place_q26, -1));
    rows.lift_step_q26 = wrapped_product(y.place_step_q26, -1);
    rows.far_q26 = p.far_sum >> 3;
    rows.up = camera.up;
    rows.forward = camera.forward;
    const auto set = [](const Vec3q30& v, int32_t(&q13)[3]) {
        q13[0] = (v.x + (1 << 16)) >> 17;
        q13[1] = (v.y + (1 << 16)) >> 17;
        q13[2] = (v.z + (1 << 16)) >> 17;
    };
    set(camera.right, rays.right_q13);
    set(camera.up, rows.up_q13);
}

int32_t rounded_q6(int32_t v_q8, uint32_t samples_log2)
{
    return (v_q8 * (int32_t{1} << samples_log2) + 2) >> 2;
}

}  // namespace

int32_t exact_back_q13(const ProxyDepths& depths, int32_t depth)
{
    const int32_t ahead = depth - static_cast<int32_t>(kFarDepth);
    if (ahead <= 0) return 0;
    const Reciprocal r = reciprocal((static_cast<uint32_t>(ahead) << depths.scale) + depths.offset);
    const int32_t leading = __builtin_clz(static_cast<uint32_t>(ahead));
    const uint32_t ratio = (((static_cast<uint32_t>(ahead) << leading) >> 16) * r.mantissa) >> 16;
    const int32_t shift = depths.shift + leading - r.leading;
    return shift > 31 ? 0 : static_cast<int32_t>((ratio * depths.factor) >> shift);
}

bool set_projection(const ProxyMesh& mesh, const GuidedCamera& camera, ProxyFrame& out)
{
    ProxyProjection& p = out.projection;
    const uint64_t focal_q12 = uint64_t{camera.focal_q12} << out.samples_log2;
    set_depth_axis(p, camera);
    if (!set_depth_range(p, mesh)) return false;
    set_place_axes(p, camera, focal_q12, 0);
    constexpr int32_t kMostShift = 30;  // of a place after the division, at the far end
    const int32_t spare = p.place_shift - __builtin_clz(static_cast<uint32_t>(p.far_z)) - kMostShift;
    if (spare > 0) set_place_axes(p, camera, focal_q12, spare);
    p.centre_x_q6 = rounded_q6(camera.centre_x_q8, out.samples_log2);
    p.centre_y_q6 = rounded_q6(camera.centre_y_q8, out.samples_log2);
    set_depth_factor(p);
    set_depths(p, out.depths);
    set_rays(p, camera, out.rays, out.row_rays);
    return true;
}

}  // namespace lumi::proxy_math
