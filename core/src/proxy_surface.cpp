// SPDX-License-Identifier: MIT
#include "lumi/proxy_surface.h"

#include "proxy_bands.h"
#include "proxy_clip.h"
#include "proxy_projection.h"

namespace lumi
{
namespace
{

using namespace proxy_math;

// The columns of samples that triangles have touched, 1/64.
struct Columns {
    int32_t least_q6, most_q6;

    void add(int32_t x_q6)
    {
        if (x_q6 < least_q6) least_q6 = x_q6;
        if (x_q6 > most_q6) most_q6 = x_q6;
    }
};

// Draws the triangles of a list that reach at least `reach` bands further.
void fill_list(const ProxyFrame& frame, uint32_t list, uint32_t reach, const DepthTarget& target, Columns& columns)
{
    uint32_t k = frame.memory.bands[list];
    if (k == kEmptyBand) return;
    for (uint32_t last = k + 1; k != last;) {
        const uint32_t link = frame.memory.links[k];
        if (link >> kLinkBits >= reach) {
            const Triple12 triangle = triple12(frame.mesh.triangles, k);
            const Corners c = corners_of(frame, triangle);
            if (c.are_all_there) {
                for (const SamplePoint& p : c.point) columns.add(p.x_q6);
                fill_triangle(c.point[0], c.point[1], c.point[2], target);
            } else {
                columns = {INT32_MIN, INT32_MAX};
                fill_clipped(frame, triangle, target);
            }
        }
        last = k;
        k = link & kLinkMask;
    }
}

// A stripe's rows meet bands that begin up to kBandReach - 1 before.
void fill_level(const ProxyFrame& frame, uint32_t first_list, uint32_t log2, const Stripe& stripe,
                const DepthTarget& target, Columns& columns)
{
    const int32_t bands = static_cast<int32_t>(proxy_bands_of_level(frame.height_px, log2));
    const int32_t first = stripe.y_px >> log2, end = ((stripe.y_px + stripe.height_px - 1) >> log2) + 1;
    for (int32_t band = first - (kBandReach - 1); band < end && band < bands; ++band) {
        if (band < 0) continue;
        const uint32_t reach = band < first ? static_cast<uint32_t>(first - band) : 0;
        fill_list(frame, first_list + static_cast<uint32_t>(band), reach, target, columns);
    }
}

void clear(uint16_t* depths, uint32_t count)
{
    __builtin_memset(depths, 0, count * sizeof *depths);
}

// The part of a stripe that lies in the image, on the sample grid; its rows remain the stripe's.
DepthTarget target_of(const ProxyFrame& frame, const Stripe& stripe, uint16_t* depths)
{
    const uint32_t log2 = frame.samples_log2;
    constexpr int32_t kHalf = 1 << 15, kQuarter = 1 << 14;
    return {depths,
            stripe.x_px * (1 << log2),
            stripe.y_px * (1 << log2),
            stripe.width_px << log2,
            stripe.height_px << log2,
            {log2 == 0 ? kHalf : kQuarter, log2 == 0 ? kHalf : 3 * kQuarter}};
}

// 2^16/n, for means of up to four.
constexpr int32_t kShareQ16[5] = {0, 65536, 32768, 21845, 16384};

// The samples of one surface; places in eighths of a pixel from its centre.
struct Group {
    int32_t first_back_q13, back_sum_q13, right_sum, down_sum;
    uint32_t samples;
};

struct Sample {
    uint32_t depth;
    int32_t right, down;
};

SurfacePoint point_of_group(const ProxyFrame& frame, const ProxyRow& row, int32_t x, const Group& g)
{
    const int32_t share_q16 = kShareQ16[g.samples];
    const int32_t back_q13 = static_cast<int32_t>((static_cast<int64_t>(g.back_sum_q13) * share_q16) >> 16);
    SurfacePoint p = proxy_point(frame.rays, row, x, back_q13, g.samples);
    // A pixel's width at that depth, R.
    const int32_t width_q26 =
        wrapped_sum(frame.rays.across_step_q26, -wrapped_product(back_q13, frame.rays.tangent_step_q26 >> 13));
    const auto part_q13 = [&](int32_t eighths) {
        return static_cast<int32_t>((static_cast<int64_t>(width_q26) * eighths * share_q16) >> 32);  // 13 + 16 + 3
    };
    const int32_t right_q13 = part_q13(g.right_sum), down_q13 = part_q13(g.down_sum);
    int32_t* const components[] = {&p.x_q14, &p.y_q14, &p.z_q14};
    for (int k = 0; k < 3; ++k) {
        *components[k] += (right_q13 * frame.rays.right_q13[k] - down_q13 * frame.rays.up_q13[k]) >> 12;
    }
    return p;
}

}  // namespace

RowSpan rasterize_proxy(const ProxyFrame& frame, const Stripe& stripe, uint16_t* depths)
{
    const DepthTarget target = target_of(frame, stripe, depths);
    clear(depths, static_cast<uint32_t>(target.width) * static_cast<uint32_t>(target.height));
    Columns columns = {INT32_MAX, INT32_MIN};
    uint32_t list = 0, log2 = frame.memory.band_log2;
    for (uint32_t level = 0; level < kBandLevels; ++level, log2 += kBandLevelLog2) {
        fill_level(frame, list, log2, stripe, target, columns);
        list += proxy_bands_of_level(frame.height_px, log2);
    }
    fill_list(frame, frame.clipped_band, 0, target, columns);
    if (columns.most_q6 < columns.least_q6) return {stripe.x_px, stripe.x_px};
    const int32_t to_pixels = static_cast<int32_t>(frame.samples_log2) + 6;
    const int32_t right = stripe.x_px + stripe.width_px;
    const auto within = [&](int32_t x) { return x < stripe.x_px ? stripe.x_px : x > right ? right : x; };
    return {within(columns.least_q6 >> to_pixels), within((columns.most_q6 >> to_pixels) + 1)};
}

ProxyRow proxy_row(const ProxyRays& rays, int32_t y)
{
    const int32_t tangent_q26 = wrapped_sum(rays.down_q26, wrapped_product(y, rays.down_step_q26));
    const int32_t lift_q26 = wrapped_sum(rays.lift_q26, wrapped_product(y, rays.lift_step_q26));
    const int32_t up[] = {rays.up.x, rays.up.y, rays.up.z};
    const int32_t forward[] = {rays.forward.x, rays.forward.y, rays.forward.z};
    ProxyRow row;
    for (int k = 0; k < 3; ++k) {
        constexpr int64_t kRounding = 1 << 11;  // of the point, Q14
        const int64_t end_q56 = wide_product(up[k], lift_q26) + wide_product(forward[k], rays.far_q26);
        row.end_q26[k] = static_cast<int32_t>(static_cast<uint32_t>((end_q56 >> 30) + kRounding));
        const int64_t ray_q56 =
            static_cast<int64_t>(forward[k]) * (int64_t{1} << 26) - wide_product(up[k], tangent_q26);
        row.ray_q13[k] = static_cast<int32_t>((ray_q56 + (int64_t{1} << 42)) >> 43);
    }
    return row;
}

int32_t exact_proxy_back(const ProxyDepths& depths, uint32_t depth)
{
    return exact_back_q13(depths, static_cast<int32_t>(depth));
}

uint32_t proxy_mixture(const ProxyFrame& frame, const ProxyRow& row, const uint16_t* upper, const uint16_t* lower,
                       int32_t x, SurfacePoint (&out)[4])
{
    const Sample samples[] = {{upper[0], -3, -2}, {upper[1], 1, -2}, {lower[0], -1, 2}, {lower[1], 3, 2}};
    Group groups[4];
    uint32_t count = 0;
    for (const Sample& s : samples) {
        if (s.depth == kEmptyDepth) continue;
        const int32_t back_q13 = proxy_back_q13(frame.depths, s.depth);
        uint32_t g = 0;
        const auto is_near = [&](int32_t d) { return d < kSameSurfaceQ13 && d > -kSameSurfaceQ13; };
        while (g < count && !is_near(back_q13 - groups[g].first_back_q13)) ++g;
        if (g == count) groups[count++] = {back_q13, 0, 0, 0, 0};
        groups[g].back_sum_q13 += back_q13;
        groups[g].right_sum += s.right;
        groups[g].down_sum += s.down;
        ++groups[g].samples;
    }
    for (uint32_t g = 0; g < count; ++g) out[g] = point_of_group(frame, row, x, groups[g]);
    return count;
}

}  // namespace lumi
