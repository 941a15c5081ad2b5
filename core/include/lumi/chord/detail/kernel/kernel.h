// SPDX-License-Identifier: MIT
// The paper's kernel on spans: (1 - d²)² of distances in spacings.
//
// Through cells both sides have four taps (distances.h); over a pole there are up to five, among the corners of the
// pixel's triangle and the points across its edges.
#pragma once

#include "lumi/chord/detail/kernel/distances.h"
#include "lumi/chord/detail/kernel/weights.h"
#include "lumi/chord/detail/linear.h"

namespace lumi::detail
{

// Points near a pixel over a pole and their squared distances in spacings², Q12. The first three are the corners of its
// triangle.
struct PolarPoints {
    static constexpr int kCount = 6;
    int32_t index[kCount];
    int32_t distance2_q12[kCount];

    // The points around the pixel whose triangle `line` has found.
    PolarPoints(const PolarLine& line, int32_t pixel);
};

// Taps of one side of a pixel whose texels are checked.
struct KernelTaps {
    static constexpr int kMost = 5;
    int count;
    int32_t offset[kMost];
    uint32_t weight[kMost];

    // At most `most` of the points over a pole, the nearest ones; weights sum to 2^bits.
    void set(const PolarPoints& near, int most, int bits);

    template <int kBits, uint32_t K>
    void set(const NearPoints& near, int32_t across)
    {
        const NearWeights of = NearWeights::of<kBits, K>(near);
        count = 0;
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            if (of.weight[k] == 0) continue;
            offset[count] = near.strand[k >> 1] + ((k & 1) != 0 ? across : 0);
            weight[count] = of.weight[k];
            ++count;
        }
    }
};

// One side of a stretch of a span through cells. Offsets of origins are found in points: in bytes they need not fit
// into 16 bits.
template <bool kInPoints>
class CellKernel
{
public:
    CellKernel(const CellLine& side, const Lattice& lattice, int32_t stride_bytes, int32_t from, int32_t length)
        : distances_(side, lattice, kInPoints ? 1 : stride_bytes, from, length),
          stride_(stride_bytes),
          across_(in_bytes(distances_.across()))
    {
    }

    int32_t base() const { return in_bytes(distances_.base()); }
    // From a strand's first point to its second one.
    int32_t across() const { return across_; }
    LUMI_ALWAYS_INLINE NearPoints near() const
    {
        NearPoints near = distances_.near();
        near.strand[0] = in_bytes(near.strand[0]);
        near.strand[1] = in_bytes(near.strand[1]);
        return near;
    }
    void advance() { distances_.advance(); }

private:
    int32_t in_bytes(int32_t offset) const { return kInPoints ? offset * stride_ : offset; }

    SpanDistances distances_;
    int32_t stride_, across_;
};

// A side of a stretch whose texels are checked: through cells or over a pole.
class SideKernel
{
public:
    SideKernel(LatticeLine& line, const Lattice& lattice, int32_t from, int32_t length) : line_(line), pixel_(from)
    {
        if (!line.over_pole) distances_ = SpanDistances(line.cells, lattice, 1, from, length);
    }

    // Points of the lattice.
    template <int kBits, uint32_t K>
    void find(KernelTaps& taps) const
    {
        constexpr int kMost = K < KernelTaps::kMost ? static_cast<int>(K) : KernelTaps::kMost;
        if (line_.over_pole) return taps.set(PolarPoints(line_.polar, pixel_), kMost, kBits);
        taps.set<kBits, K>(distances_.near(), distances_.across());
        for (int k = 0; k < taps.count; ++k) taps.offset[k] += distances_.base();
    }
    void advance()
    {
        ++pixel_;
        if (line_.over_pole) return line_.polar.advance(pixel_);
        distances_.advance();
    }

private:
    LatticeLine& line_;
    int32_t pixel_;
    SpanDistances distances_;
};

// How many pixels from `from` on make a stretch that both sides can follow.
template <class IsFollowed>
int32_t stretch_length(int32_t rest, IsFollowed is_followed)
{
    int32_t length = rest < SpanDistances::kMostPixels ? rest : SpanDistances::kMostPixels;
    while (length > 1 && !is_followed(length)) length >>= 1;
    return length;
}

// Calls visit(origins, directions, base pointer, pixel pointer) for every pixel of a piece through cells.
template <class Texel, class Pixel, class Background, class Visit>
void for_cell_pixels(CellPiece<Background>& span, Visit visit)
{
    const Field& field = span.field;
    const int32_t stride = static_cast<int32_t>(field.row_stride_bytes);
    const int32_t bytes = static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat));
    const auto is_followed = [&](int32_t length) {
        return SpanDistances::is_followed(span.origins, length) && SpanDistances::is_followed(span.directions, length);
    };
    int32_t scanlines_left = span.scanlines();
    span.go_to_first();
    do {
        uint8_t* pixel = span.pixels;
        for (int32_t from = 0, length = 0; from < span.length; from += length) {
            length = stretch_length(span.length - from, is_followed);
            CellKernel<true> origins(span.origins, field.origins, stride, from, length);
            CellKernel<false> directions(span.directions, field.directions, bytes, from, length);
            const uint8_t* const base = settled(field.texels + origins.base() + directions.base());
            for (const uint8_t* end = pixel + static_cast<uint32_t>(length) * Pixel::kBytes; pixel != end;
                 pixel += Pixel::kBytes) {
                visit(origins, directions, base, pixel);
                origins.advance();
                directions.advance();
            }
        }
    } while (span.go_down(scanlines_left));
}

// Calls visit(origins, directions, pixel pointer) for every pixel of a piece whose texels are checked.
template <class Pixel, class Background, class Visit>
void for_checked_pixels(const CheckedPiece<Background>& span, Visit visit)
{
    const auto is_followed = [&](int32_t length) {
        return (span.origins.over_pole || SpanDistances::is_followed(span.origins.cells, length)) &&
               (span.directions.over_pole || SpanDistances::is_followed(span.directions.cells, length));
    };
    uint8_t* pixel = span.pixels;
    for (int32_t from = 0, length = 0; from < span.length; from += length) {
        length = stretch_length(span.length - from, is_followed);
        SideKernel origins(span.origins, span.field.origins, from, length);
        SideKernel directions(span.directions, span.field.directions, from, length);
        for (int32_t k = 0; k < length; ++k, pixel += Pixel::kBytes) {
            visit(origins, directions, pixel);
            origins.advance();
            directions.advance();
        }
    }
}

template <uint32_t K>
struct SpanDraw<Paper<K>> {
    template <class Texel, class Pixel, class Background>
    static void draw(CellPiece<Background>& span)
    {
        // Rows of texels without weight are left out: one in four.
        using Sum = TexelSum<Texel, !Background::kIsBlack>;
        const auto visit = [&](const CellKernel<true>& origins, const CellKernel<false>& directions,
                               const uint8_t* base, uint8_t* pixel) {
            const NearPoints o = origins.near();
            const NearPoints d = directions.near();
            const NearWeights rows = NearWeights::of<Sum::kRowBits, K>(o);
            const NearWeights taps = NearWeights::of<Sum::kTapBits, K>(d);
            const uint8_t* const texels = base + d.strand[0] - Sum::kBefore;
            const uint8_t* const row_of_strand[2] = {settled(texels + o.strand[0]), settled(texels + o.strand[1])};
            const int32_t across = directions.across();
            const int32_t next = d.strand[1] - d.strand[0];
            const int32_t last = settled(next + across);
            Sum sum;
#pragma GCC unroll 4
            for (int m = 0; m < 4; ++m) {
                if (rows.weight[m] == 0) continue;
                const uint8_t* const row = row_of_strand[m >> 1] + ((m & 1) != 0 ? origins.across() : 0);
                typename Sum::Row of_row;
                of_row.add(span.field, row, taps.weight[0]);
                of_row.add(span.field, row + across, taps.weight[1]);
                of_row.add(span.field, row + next, taps.weight[2]);
                of_row.add(span.field, row + last, taps.weight[3]);
                add_plainly(sum, of_row, rows.weight[m]);
            }
            sum.template store<Pixel>(span.background, pixel);
        };
        for_cell_pixels<Texel, Pixel>(span, visit);
    }

    template <class Texel, class Pixel, class Background>
    static void draw_checked(const CheckedPiece<Background>& span)
    {
        using Sum = TexelSum<Texel, !Background::kIsBlack>;
        const auto visit = [&](const SideKernel& o, const SideKernel& d, uint8_t* pixel) {
            KernelTaps origins{};
            KernelTaps directions{};
            o.find<Sum::kRowBits, K>(origins);
            d.find<Sum::kTapBits, K>(directions);
            uint32_t offset[KernelTaps::kMost];
            for (int k = 0; k < directions.count; ++k) offset[k] = span.template offset<Texel>(directions.offset[k]);
            Sum sum;
            for (int m = 0; m < origins.count; ++m) {
                const uint8_t* const row = span.row(origins.offset[m]);
                if (row == nullptr) continue;
                typename Sum::Row taps;
                for (int k = 0; k < directions.count; ++k)
                    taps.add(span.field, row + offset[k] - Sum::kBefore, directions.weight[k]);
                sum.add(taps, row_weight<Sum>(origins.weight[m]));
            }
            sum.template store<Pixel>(span.background, pixel);
        };
        for_checked_pixels<Pixel>(span, visit);
    }
};

}  // namespace lumi::detail
