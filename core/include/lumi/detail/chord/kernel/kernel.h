// SPDX-License-Identifier: MIT
// The paper's kernel and the true nearest point on spans: (1 - d²)² of distances in spacings.
//
// Through cells both sides have four taps (span_distance.h); over a cap there are up to five, among the corners of the
// pixel's triangle and the points across its edges.
#pragma once

#include "lumi/detail/chord/kernel/distances.h"
#include "lumi/detail/chord/loops.h"
#include "lumi/detail/chord/kernel/weights.h"

namespace lumi
{

// Points near a pixel over a cap: offsets in memory and squared distances in spacings², Q12. The first three are the
// corners of its triangle.
inline constexpr int kCapCandidates = 6;
struct CapPoints {
    int32_t offset[kCapCandidates];
    int32_t distance2_q12[kCapCandidates];

    // Of the pixel whose triangle `cap` has found.
    CapPoints(const SpanCap& cap, int32_t pixel, int32_t step_bytes);
};

// Taps of one side of a pixel, through cells or over a cap.
struct KernelTaps {
    static constexpr int kMost = 5;
    int count;
    int32_t offset[kMost];
    uint32_t weight[kMost];

    // At most `most` of a cap's points, the nearest ones; weights sum to 2^bits.
    void set(const CapPoints& near, int most, int bits);

    template <int kBits, uint32_t K>
    void set(const NearPoints& near, int32_t across)
    {
        const NearWeights of = NearWeights::of<kBits, K>(near);
        count = 0;
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            if (of.weight[k] == 0) continue;
            offset[count] = near.row[k >> 1] + ((k & 1) != 0 ? across : 0);
            weight[count] = of.weight[k];
            ++count;
        }
    }
};

// One side of a piece of a span through cells. Offsets of origins are found in points: in bytes they need not fit into
// 16 bits.
template <bool kInPoints>
class CellKernel
{
public:
    CellKernel(const SpanSide& side, const Lattice& lattice, int32_t stride_bytes, int32_t from, int32_t length)
        : distances_(side, lattice, kInPoints ? 1 : stride_bytes, from, length),
          stride_(stride_bytes),
          across_(in_bytes(distances_.across()))
    {
    }

    int32_t base() const { return in_bytes(distances_.base()); }
    // From a row's first point to its second one.
    int32_t across() const { return across_; }
    LUMI_ALWAYS_INLINE NearPoints near() const
    {
        NearPoints near = distances_.near();
        near.row[0] = in_bytes(near.row[0]);
        near.row[1] = in_bytes(near.row[1]);
        return near;
    }
    template <int kBits, uint32_t K>
    void find(KernelTaps& taps) const
    {
        taps.set<kBits, K>(near(), across());
    }
    int32_t nearest() const
    {
        const NearPoints at = near();
        const int32_t* const below = at.below_q26;
        const int32_t first = at.row[0] + (below[1] < below[0] ? across() : 0);
        const int32_t second = at.row[1] + (below[3] < below[2] ? across() : 0);
        const auto least = [](int32_t a, int32_t b) { return a < b ? a : b; };
        return least(below[2], below[3]) < least(below[0], below[1]) ? second : first;
    }
    void advance() { distances_.advance(); }

private:
    int32_t in_bytes(int32_t offset) const { return kInPoints ? offset * stride_ : offset; }

    SpanDistances distances_;
    int32_t stride_, across_;
};

// The same over a cap.
class CapKernel
{
public:
    CapKernel(const SpanSide& side, const Lattice&, int32_t stride_bytes, int32_t from, int32_t)
        : cap_(*side.cap), pixel_(from), step_(side.first * stride_bytes), base_(side.base * stride_bytes)
    {
    }

    int32_t base() const { return base_; }
    template <int kBits, uint32_t K>
    void find(KernelTaps& taps) const
    {
        constexpr int kMost = K < KernelTaps::kMost ? static_cast<int>(K) : KernelTaps::kMost;
        taps.set(CapPoints(cap_, pixel_, step_), kMost, kBits);
    }
    // Among the corners of the pixel's triangle: no other point is nearer, as no triangle is obtuse.
    int32_t nearest() const
    {
        const CapPoints near(cap_, pixel_, step_);
        const int first = near.distance2_q12[1] < near.distance2_q12[0] ? 1 : 0;
        return near.offset[near.distance2_q12[2] < near.distance2_q12[first] ? 2 : first];
    }
    void advance() { cap_.advance(++pixel_); }

private:
    SpanCap& cap_;
    int32_t pixel_, step_, base_;
};

// Calls visit(origins, directions, base pointer, pixel pointer) for every pixel, in pieces as long as the coordinates
// of both sides allow.
template <class Origins, class Directions, class Texel, class Pixel, class Background, class Visit>
void for_kernel_pixels(SpanTarget<Background>& span, Visit visit)
{
    const Field& field = span.field;
    const int32_t stride = static_cast<int32_t>(field.row_stride_bytes);
    const int32_t bytes = static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat));
    const auto is_followed = [](const SpanSide& side, int32_t length) {
        return side.cap != nullptr || SpanDistances::is_followed(side, length);
    };
    int32_t rows_left = span.rows();
    span.go_to_first();
    do {
        uint8_t* pixel = span.pixels;
        for (int32_t from = 0, length = 0; from < span.length; from += length) {
            length = span.length - from < SpanDistances::kMostPixels ? span.length - from : SpanDistances::kMostPixels;
            if (!can_follow(span.origins, span.directions, length)) {
                while (length > 1 && !(is_followed(span.origins, length) && is_followed(span.directions, length)))
                    length >>= 1;
            }
            Origins origins(span.origins, field.origins, stride, from, length);
            Directions directions(span.directions, field.directions, bytes, from, length);
            const uint8_t* const base = settled(field.texels + origins.base() + directions.base());
            for (const uint8_t* end = pixel + static_cast<uint32_t>(length) * Pixel::kBytes; pixel != end;
                 pixel += Pixel::kBytes) {
                visit(origins, directions, base, pixel);
                origins.advance();
                directions.advance();
            }
        }
    } while (span.go_down(rows_left));
}

template <class Drawing, class Texel, class Pixel, class Background>
void draw_by_sides(SpanTarget<Background>& span)
{
    if (!span.is_over_cap()) return Drawing::template draw_cells<Texel, Pixel>(span);
    if (span.directions.cap == nullptr)
        return Drawing::template draw_sides<CapKernel, CellKernel<false>, Texel, Pixel>(span);
    if (span.origins.cap == nullptr)
        return Drawing::template draw_sides<CellKernel<true>, CapKernel, Texel, Pixel>(span);
    Drawing::template draw_sides<CapKernel, CapKernel, Texel, Pixel>(span);
}

template <uint32_t K>
struct SpanDraw<Paper<K>> {
    template <class Texel, class Pixel, class Background>
    static void draw(SpanTarget<Background>& span)
    {
        draw_by_sides<SpanDraw, Texel, Pixel>(span);
    }

    // Through cells. Rows without weight are left out: one in four.
    template <class Texel, class Pixel, class Background>
    static void draw_cells(SpanTarget<Background>& span)
    {
        using Sum = SpanSum<Texel, !Background::kIsBlack>;
        const auto visit = [&](const CellKernel<true>& origins, const CellKernel<false>& directions,
                               const uint8_t* base, uint8_t* pixel) {
            const NearPoints o = origins.near();
            const NearPoints d = directions.near();
            const NearWeights rows = NearWeights::of<Sum::kRowBits, K>(o);
            const NearWeights taps = NearWeights::of<Sum::kTapBits, K>(d);
            const uint8_t* const texels = base + d.row[0] - Sum::kBefore;
            const uint8_t* const row_pair[2] = {settled(texels + o.row[0]), settled(texels + o.row[1])};
            const int32_t across = directions.across();
            const int32_t next = d.row[1] - d.row[0];
            const int32_t last = settled(next + across);
            Sum sum;
#pragma GCC unroll 4
            for (int m = 0; m < 4; ++m) {
                if (rows.weight[m] == 0) continue;
                const uint8_t* const row = row_pair[m >> 1] + ((m & 1) != 0 ? origins.across() : 0);
                typename Sum::Row of_row;
                of_row.add(span.field, row, taps.weight[0]);
                of_row.add(span.field, row + across, taps.weight[1]);
                of_row.add(span.field, row + next, taps.weight[2]);
                of_row.add(span.field, row + last, taps.weight[3]);
                add_plainly(sum, of_row, rows.weight[m]);
            }
            sum.template store<Pixel>(span.background, pixel);
        };
        for_kernel_pixels<CellKernel<true>, CellKernel<false>, Texel, Pixel>(span, visit);
    }

    // A side over a cap.
    template <class Origins, class Directions, class Texel, class Pixel, class Background>
    static void draw_sides(SpanTarget<Background>& span)
    {
        using Sum = SpanSum<Texel, !Background::kIsBlack>;
        const auto visit = [&](const Origins& o, const Directions& d, const uint8_t* base, uint8_t* pixel) {
            KernelTaps origins{};
            KernelTaps directions{};
            o.template find<Sum::kRowBits, K>(origins);
            d.template find<Sum::kTapBits, K>(directions);
            Sum sum;
            for (int m = 0; m < origins.count; ++m) {
                const uint8_t* const row = base + origins.offset[m] - Sum::kBefore;
                typename Sum::Row taps;
#pragma GCC unroll 5
                for (int k = 0; k < KernelTaps::kMost; ++k) {
                    if (k == directions.count) break;
                    taps.add(span.field, row + directions.offset[k], directions.weight[k]);
                }
                sum.add(taps, row_weight<Sum>(origins.weight[m]));
            }
            sum.template store<Pixel>(span.background, pixel);
        };
        for_kernel_pixels<Origins, Directions, Texel, Pixel>(span, visit);
    }
};

template <>
struct SpanDraw<NearestVoronoi> {
    template <class Texel, class Pixel, class Background>
    static void draw(SpanTarget<Background>& span)
    {
        draw_by_sides<SpanDraw, Texel, Pixel>(span);
    }

    template <class Texel, class Pixel, class Background>
    static void draw_cells(SpanTarget<Background>& span)
    {
        draw_sides<CellKernel<true>, CellKernel<false>, Texel, Pixel>(span);
    }

    template <class Origins, class Directions, class Texel, class Pixel, class Background>
    static void draw_sides(SpanTarget<Background>& span)
    {
        const auto visit = [&](const Origins& o, const Directions& d, const uint8_t* base, uint8_t* pixel) {
            store_single<Texel, Pixel>(span.field, span.background, base + o.nearest() + d.nearest(), pixel);
        };
        for_kernel_pixels<Origins, Directions, Texel, Pixel>(span, visit);
    }
};

}  // namespace lumi
