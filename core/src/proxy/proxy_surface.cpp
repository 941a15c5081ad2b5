// SPDX-License-Identifier: MIT
#include "lumi/proxy/proxy_surface.h"

#include "proxy/proxy_bands.h"
#include "proxy/proxy_clip.h"
#include "proxy/proxy_projection.h"

namespace lumi
{
namespace
{

using namespace proxy_math;

// The columns of samples that triangles have touched, as ProxyVertex packs them.
struct Columns {
    int32_t least, most;
};

LUMI_ALWAYS_INLINE void add(Columns& columns, const Corners& c)
{
    const int32_t a = c.a->x, b = c.b->x, d = c.c->x;
    const int32_t least = least_of(a, b, d), most = most_of(a, b, d);
    if (least < columns.least) columns.least = least;
    if (most > columns.most) columns.most = most;
}

// Draws the triangles of a list that reach at least `reach` bands further.
template <bool kShifted>
void fill_list(const ProxyFrame& frame, uint32_t list, uint32_t reach, const DepthTarget& target, Columns& all)
{
    uint32_t k = frame.memory.bands[list];
    if (k == kEmptyBand) return;
    Columns columns = all;
    for (uint32_t last = k + 1; k != last;) {
        const uint32_t link = frame.memory.links[k];
        if (link >> kLinkBits >= reach) {
            ProxyVertex room[3];
            const Corners c = corners_of(frame, triple12(frame.mesh.triangles, k), room);
            add(columns, c);
            const bool inside =
                frame.mesh.two_sided && doubled_area(unpacked(*c.a), unpacked(*c.b), unpacked(*c.c)) > 0;
            fill_small_triangle<kShifted>(*c.a, inside ? *c.c : *c.b, inside ? *c.b : *c.c, target);
        }
        last = k;
        k = link & kLinkMask;
    }
    all = columns;
}

// Draws the triangles that are cut or large.
void fill_others(const ProxyFrame& frame, const DepthTarget& target, Columns& columns)
{
    uint32_t k = frame.memory.bands[frame.clipped_band];
    if (k == kEmptyBand) return;
    for (uint32_t last = k + 1; k != last;) {
        const Triple12 triangle = triple12(frame.mesh.triangles, k);
        ProxyVertex room[3];
        const Corners c = corners_of(frame, triangle, room);
        if (c.are_all_there()) {
            add(columns, c);
            fill_triangle(*c.a, *c.b, *c.c, target);
        } else {
            columns = {INT32_MIN, INT32_MAX};
            fill_clipped(frame, triangle, target);
        }
        last = k;
        k = frame.memory.links[k] & kLinkMask;
    }
}

// A stripe's rows meet bands that begin up to kBandReach - 1 before.
template <bool kShifted>
void fill_level(const ProxyFrame& frame, uint32_t first_list, uint32_t log2, const Stripe& stripe,
                const DepthTarget& target, Columns& columns)
{
    const int32_t bands = static_cast<int32_t>(proxy_bands_of_level(frame.height_px, log2));
    const int32_t first = stripe.y_px >> log2, end = ((stripe.y_px + stripe.height_px - 1) >> log2) + 1;
    for (int32_t band = first - (kBandReach - 1); band < end && band < bands; ++band) {
        if (band < 0) continue;
        const uint32_t reach = band < first ? static_cast<uint32_t>(first - band) : 0;
        fill_list<kShifted>(frame, first_list + static_cast<uint32_t>(band), reach, target, columns);
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
    constexpr int32_t kHalf = 32, kQuarter = 16;
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
    int32_t back_sum_q13, right_sum, down_sum;
    uint32_t samples;
};

struct SamplePlace {
    int8_t right, down;
};
constexpr SamplePlace kPlaces[4] = {{-3, -2}, {1, -2}, {-1, 2}, {3, 2}};

SurfacePoint point_of_group(const ProxyFrame& frame, const ProxyRow& row, int32_t x, const Group& g)
{
    const int32_t share_q16 = kShareQ16[g.samples];
    const int32_t back_q13 = (g.back_sum_q13 * share_q16) >> 16;
    SurfacePoint p = proxy_point(frame.rays, row, x, back_q13, g.samples);
    // A pixel's width at that depth, R.
    const int32_t width_q26 =
        wrapped_sum(frame.rays.across_step_q26, -wrapped_product(back_q13, frame.rays.tangent_step_q26 >> 13));
    const int32_t width_part_q26 = times_q16(width_q26, static_cast<uint32_t>(share_q16));
    const int32_t right_q13 = wrapped_product(width_part_q26, g.right_sum) >> 16;  // 13, and 3 of the eighths
    const int32_t down_q13 = wrapped_product(width_part_q26, g.down_sum) >> 16;
    int32_t* const components[] = {&p.x_q14, &p.y_q14, &p.z_q14};
    for (int k = 0; k < 3; ++k) {
        *components[k] += (right_q13 * frame.rays.right_q13[k] - down_q13 * frame.row_rays.up_q13[k]) >> 12;
    }
    return p;
}

}  // namespace

template <uint32_t Samples>
RowSpan rasterize_proxy(const ProxyFrame& frame, const Stripe& stripe, uint16_t* depths)
{
    const DepthTarget target = target_of(frame, stripe, depths);
    clear(depths, static_cast<uint32_t>(target.width) * static_cast<uint32_t>(target.height));
    constexpr bool kShifted = Samples > 1;
    Columns columns = {INT32_MAX, INT32_MIN};
    uint32_t list = 0, log2 = frame.memory.band_log2;
    for (uint32_t level = 0; level < kBandLevels; ++level, log2 += kBandLevelLog2) {
        fill_level<kShifted>(frame, list, log2, stripe, target, columns);
        list += proxy_bands_of_level(frame.height_px, log2);
    }
    fill_others(frame, target, columns);
    if (columns.most < columns.least) return {stripe.x_px, stripe.x_px};
    const int32_t to_pixels = static_cast<int32_t>(frame.samples_log2) + 6 + 8;
    const int32_t right = stripe.x_px + stripe.width_px;
    const auto within = [&](int32_t x) { return x < stripe.x_px ? stripe.x_px : x > right ? right : x; };
    return {within(columns.least >> to_pixels), within((columns.most >> to_pixels) + 1)};
}

template RowSpan rasterize_proxy<1>(const ProxyFrame&, const Stripe&, uint16_t*);
template RowSpan rasterize_proxy<4>(const ProxyFrame&, const Stripe&, uint16_t*);

ProxyRow proxy_row(const ProxyRowRays& rays, int32_t y)
{
    const int32_t tangent_q26 = wrapped_sum(rays.down_q26, wrapped_product(y, rays.down_step_q26));
    const int32_t lift_q26 = wrapped_sum(rays.lift_q26, wrapped_product(y, rays.lift_step_q26));
    const int32_t up[] = {rays.up.x, rays.up.y, rays.up.z};
    const int32_t forward[] = {rays.forward.x, rays.forward.y, rays.forward.z};
    ProxyRow row;
    for (int k = 0; k < 3; ++k) {
        constexpr int64_t kRounding = 1 << 11;  // of the point, Q14
        const int64_t end_q56 = wide_product(up[k], lift_q26) + wide_product(forward[k], rays.far_q26);
        row.component[k].end_q26 = static_cast<int32_t>(static_cast<uint32_t>((end_q56 >> 30) + kRounding));
        const int64_t ray_q56 =
            static_cast<int64_t>(forward[k]) * (int64_t{1} << 26) - wide_product(up[k], tangent_q26);
        row.component[k].ray_q13 = static_cast<int32_t>((ray_q56 + (int64_t{1} << 42)) >> 43);
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
    constexpr int32_t kNone = -(1 << 20);  // far from every depth
    int32_t back_q13[4] = {upper[0], upper[1], lower[0], lower[1]};
    for (int32_t& back : back_q13) {
        const uint32_t depth = static_cast<uint32_t>(back);
        back = depth == kEmptyDepth ? kNone : proxy_back_q13(frame.depths, depth);
    }
    uint32_t count = 0;
    for (int first = 0; first < 4; ++first) {
        const int32_t first_q13 = back_q13[first];
        if (first_q13 == kNone) continue;
        Group g = {0, 0, 0, 0};
        for (int k = first; k < 4; ++k) {
            const int32_t difference_q13 = back_q13[k] - first_q13;
            if (difference_q13 >= kSameSurfaceQ13 || difference_q13 <= -kSameSurfaceQ13) continue;
            g.back_sum_q13 += back_q13[k];
            g.right_sum += kPlaces[k].right;
            g.down_sum += kPlaces[k].down;
            ++g.samples;
            back_q13[k] = kNone;
        }
        out[count++] = point_of_group(frame, row, x, g);
    }
    return count;
}

}  // namespace lumi
