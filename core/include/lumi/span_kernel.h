// SPDX-License-Identifier: MIT
// The paper's kernel and the true nearest point on spans: distances in the plane of a span's cells.
//
// In lattice coordinates the squared distance is a quadratic form that depends on one number, the zone's shape
// X = √5·π·n·(1 - z²)/Φ^2k in [1, Φ²]. In units of the mean spacing, for steps F_k and F_k+1 (with F_k ≈ Φ^k/√5):
//     E = (X + 1/X)/√5,  F = (Φ/X - X/Φ)/√5,  G = (X/Φ² + Φ²/X)/√5.
// The candidates are the corners of the query's triangle and the points across its edges: the disc of one spacing holds
// no other point of weight.
#pragma once

#include "lumi/span_draw.h"

namespace lumi
{

inline constexpr int kKernelCandidates = 6;

// Points near a pixel: offsets in memory and squared distances in spacings², Q12.
struct SpanNeighbours {
    int32_t offset[kKernelCandidates];
    int32_t distance2_q12[kKernelCandidates];
};

// The quadratic form of a span's cells, Q12.
struct SpanMetric {
    int32_t e_q12, f_q12, g_q12;

    explicit SpanMetric(const SpanSide& side);
};

// Walks one side of a span, through cells or over a cap, and names the candidates of each pixel.
class KernelSource
{
public:
    KernelSource(const SpanSide& side, int32_t stride_bytes)
        : steps_(side, stride_bytes), metric_(side), side_(side), u_q16_(side.u_q16), v_q16_(side.v_q16), cap_(side.cap)
    {
    }

    int32_t base() const { return steps_.base; }

    // The candidates; the first three are the corners of the pixel's triangle, of which alone kThree leaves the others
    // undefined.
    template <bool kThree>
    LUMI_ALWAYS_INLINE SpanNeighbours neighbours() const
    {
        return side_.cap != nullptr ? cap_neighbours() : cell_neighbours<kThree>();
    }

    void advance()
    {
        if (side_.cap != nullptr) {
            cap_->advance(++pixel_);
        } else {
            u_q16_ += side_.du_q16;
            v_q16_ += side_.dv_q16;
        }
    }

private:
    // With f the position in the cell, M the form and c a corner's steps, the squared distance to the corner is
    // f·M·f - 2·c·M·f + c·M·c: all candidates of a pixel share the products of the first two.
    template <bool kThree>
    LUMI_ALWAYS_INLINE SpanNeighbours cell_neighbours() const
    {
        const int32_t fu = (u_q16_ >> 4) & 4095;
        const int32_t fv = (v_q16_ >> 4) & 4095;
        const int32_t corner = steps_.corner(u_q16_, v_q16_);
        const int32_t mu = (metric_.e_q12 * fu + metric_.f_q12 * fv) >> 12;
        const int32_t mv = (metric_.f_q12 * fu + metric_.g_q12 * fv) >> 12;
        const int32_t here = (mu * fu + mv * fv) >> 12;
        const Axis u = {steps_.first, metric_.e_q12 - 2 * mu, 2 * mu};
        const Axis v = {steps_.second, metric_.g_q12 - 2 * mv, 2 * mv};
        const int32_t both = 2 * metric_.f_q12;
        SpanNeighbours result;
        const auto set = [&](int k, int32_t offset, int32_t distance2_q12) {
            result.offset[k] = corner + offset;
            result.distance2_q12[k] = here + distance2_q12;
        };
        const int32_t across = u.step + v.step;
        if (__builtin_expect(steps_.is_flipped(corner), false)) {
            const bool near = fu + fv < 4096;
            set(near ? 0 : 3, 0, 0);
            set(1, u.step, u.one);
            set(2, v.step, v.one);
            set(near ? 3 : 0, across, u.one + v.one + both);
            if (!near) {
                set(4, 2 * u.step, 2 * u.one + 2 * metric_.e_q12);
                set(5, 2 * v.step, 2 * v.one + 2 * metric_.g_q12);
            } else {
                set(4, u.step - v.step, u.one + v.minus_one(metric_.g_q12) - both);
                set(5, v.step - u.step, v.one + u.minus_one(metric_.e_q12) - both);
            }
            return result;
        }
        // The triangle below the diagonal; the one above it is the same with u and v exchanged.
        const bool lower = fu > fv;
        const Axis& a = lower ? u : v;
        const Axis& b = lower ? v : u;
        const int32_t aa = lower ? metric_.e_q12 : metric_.g_q12;
        const int32_t bb = lower ? metric_.g_q12 : metric_.e_q12;
        const int32_t diagonal = a.one + b.one + both;
        set(0, 0, 0);
        set(1, a.step, a.one);
        set(2, across, diagonal);
        if (kThree) return result;
        set(3, b.step, b.one);
        set(4, -b.step, b.minus_one(bb));
        set(5, across + a.step, diagonal + a.one + 2 * aa + both);
        return result;
    }

    // One step along u or v: its offset, and what it adds to the squared distance. Two steps add 2·one + 2·c·M·c.
    struct Axis {
        int32_t step, one, twice_m;

        int32_t minus_one(int32_t own_q12) const { return own_q12 + twice_m; }
    };

    SpanNeighbours cap_neighbours() const;

    SpanSteps steps_;
    SpanMetric metric_;
    const SpanSide& side_;
    int32_t u_q16_, v_q16_;
    SpanCap* cap_;
    int32_t pixel_ = 0;
};

// Offsets of a side's points relative to SpanSteps::base: from the lowest on.
struct OffsetRange {
    int32_t lowest;
    uint32_t extent;

    bool holds(int32_t offset) const { return static_cast<uint32_t>(offset - lowest) <= extent; }

    OffsetRange(const SpanSide& side, uint32_t points, int32_t stride_bytes)
        : lowest(-side.base * stride_bytes), extent((points - 1) * static_cast<uint32_t>(stride_bytes))
    {
    }
};

// Taps of weight: the kernel's (1 - d²)², normalised to 2^bits; the first takes what rounding leaves.
struct KernelTaps {
    int count;
    int32_t offset[kKernelCandidates];
    uint32_t weight[kKernelCandidates];

    // At most `most` taps, the nearest ones. `lowest` and `highest` bound the offsets that exist: near a pole a
    // candidate may lie beyond it.
    KernelTaps(const SpanNeighbours& near, uint32_t most, const OffsetRange& range, int bits);

private:
    uint32_t drop_lightest();
};

// The corner of a pixel's triangle at the least distance: no other lattice point is nearer, since no triangle is
// obtuse.
inline int32_t nearest_offset(const SpanNeighbours& near)
{
    const int first = near.distance2_q12[1] < near.distance2_q12[0] ? 1 : 0;
    return near.offset[near.distance2_q12[2] < near.distance2_q12[first] ? 2 : first];
}

// Calls visit(candidates of the origins, of the directions, base pointer, pixel pointer) for every pixel.
template <int kCandidates, class Texel, class Pixel, class Background, class Visit>
void for_kernel_pixels(const SpanTarget<Background>& span, Visit visit)
{
    KernelSource origins(span.origins, static_cast<int32_t>(span.field.row_stride_bytes));
    KernelSource directions(span.directions, static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat)));
    const uint8_t* base = span.field.texels + origins.base() + directions.base();
    uint8_t* pixel = span.pixels;
    for (int32_t k = 0; k < span.length; ++k, pixel += Pixel::kBytes) {
        visit(origins.template neighbours<kCandidates == 3>(), directions.template neighbours<kCandidates == 3>(), base,
              pixel);
        origins.advance();
        directions.advance();
    }
}

template <uint32_t K>
struct SpanDraw<Paper<K>> {
    template <class Texel, class Pixel, class Background>
    static void draw(const SpanTarget<Background>& span)
    {
        using Sum = SpanSum<Texel, !Background::kIsBlack>;
        constexpr int kTaps = K < kKernelCandidates ? static_cast<int>(K) : kKernelCandidates;
        const int32_t stride = static_cast<int32_t>(span.field.row_stride_bytes);
        const int32_t bytes = static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat));
        const OffsetRange rows(span.origins, span.field.used_origins, stride);
        const OffsetRange columns(span.directions, span.field.directions.size(), bytes);
        for_kernel_pixels<kKernelCandidates, Texel, Pixel>(
            span, [&](const SpanNeighbours& o, const SpanNeighbours& d, const uint8_t* base, uint8_t* pixel) {
                const KernelTaps origins(o, K, rows, Sum::kRowBits);
                const KernelTaps directions(d, K, columns, Sum::kTapBits);
                Sum sum;
                for (int m = 0; m < origins.count; ++m) {
                    const uint8_t* row = base + origins.offset[m] - Sum::kBefore;
                    typename Sum::Row taps;
#pragma GCC unroll 6
                    for (int k = 0; k < kTaps; ++k) {
                        if (k == directions.count) break;
                        taps.add(span.field, row + directions.offset[k], directions.weight[k]);
                    }
                    sum.add(taps, row_weight<Sum>(origins.weight[m]));
                }
                sum.template store<Pixel>(span.background, pixel);
            });
    }
};

template <>
struct SpanDraw<NearestVoronoi> {
    template <class Texel, class Pixel, class Background>
    static void draw(const SpanTarget<Background>& span)
    {
        for_kernel_pixels<3, Texel, Pixel>(
            span, [&](const SpanNeighbours& o, const SpanNeighbours& d, const uint8_t* base, uint8_t* pixel) {
                const uint8_t* texel = base + nearest_offset(o) + nearest_offset(d);
                store_single<Texel, Pixel>(span.field, span.background, texel, pixel);
            });
    }
};

}  // namespace lumi
