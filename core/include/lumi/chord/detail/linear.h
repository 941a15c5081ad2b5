// SPDX-License-Identifier: MIT
// The loops of Linear read 3×3 texels a pixel.
#pragma once

#include "lumi/chord/detail/both_sides.h"
#include "lumi/chord/detail/linear_armv6m.h"
#include "lumi/chord/detail/piece.h"
#include "lumi/chord/detail/side_taps.h"
#include "lumi/chord/detail/sums.h"
#include "lumi/chord/reconstruction.h"

namespace lumi::detail
{

// Goes through cells, both sides at once: all scanlines of a tile, or without one the span's.
template <bool kFlips, class Texel, class Pixel, class Background>
void draw_both_sides(const CellPiece<Background>& span, const TileScanlines* tile)
{
    LUMI_TALLY(Work::linear_piece, 1);
    using Sum = TexelSum<Texel, !Background::kIsBlack>;
    const Field field = span.field;  // stores of pixels do not change it
    BothSidesWalk<kFlips> both(
        span.origins, span.directions, field.texels - Sum::kBefore,
        {static_cast<int32_t>(field.row_stride_bytes), static_cast<int32_t>(format::bytes_per_texel(Texel::kFormat))});
    BothSidesScanlines scanlines(span, tile);
    for (;;) {
        LUMI_TALLY(nth_work(Work::linear_pixel, static_cast<uint32_t>(Texel::kFormat)), span.length);
        LUMI_TALLY(Work::flipped_pixel, kFlips ? span.length : 0);
        both.begin(scanlines);
        DoubleWord<uint8_t*> pixels = {scanlines.pixels(),
                                       scanlines.pixels() + static_cast<uint32_t>(span.length) * Pixel::kBytes};
        for (bool is_last = false; !is_last;) {
            const Sum sum = sum_of<Sum>(field, both.template taps<Sum>());
            const DoubleWord<uint8_t*> at = reload(pixels);
            sum.template store<Pixel>(span.background, at.a);
            pixels.a = at.a + Pixel::kBytes;
            is_last = pixels.a == at.b;
        }
        if (!scanlines.go_down()) return;
    }
}

// Draws by the assembly loop of the core: first the sums of a scanline, then its pixels.
template <class Texel, class Pixel, class Background>
void draw_assembled(const CellPiece<Background>& span, const TileScanlines* tile)
{
    using Sum = TexelSum<Texel, false>;
    using Loop = Armv6mLoop<Sum>;
    const uint8_t* const palette = span.field.palette;
    const uint32_t words = static_cast<uint32_t>(span.length) * Loop::kWords;
    typename Loop::Scanlines cells(span.origins, span.directions, span.field, format::bytes_per_texel(Texel::kFormat),
                                   {Sum::kRowBits, Sum::kTapBits});
    BothSidesScanlines scanlines(span, tile);
    do {
        uint32_t sums[kMostSpanPixels * Loop::kWords];
        const uint32_t* const end = sums + words;
        Loop::draw(sums, end, cells.before(scanlines), palette);
        uint8_t* pixel = scanlines.pixels();
        for (const uint32_t* at = sums; at != end; at += Loop::kWords, pixel += Pixel::kBytes)
            Loop::sum(at).template store<Pixel>(span.background, pixel);
    } while (scanlines.go_down());
}

template <class Texel, class Pixel, class Background>
void draw_cells(const CellPiece<Background>& span, const TileScanlines* tile)
{
    if constexpr (Armv6mLoop<TexelSum<Texel, !Background::kIsBlack>>::kExists) {
        draw_assembled<Texel, Pixel>(span, tile);
    } else {
        if (span.origins.uniform && span.directions.uniform) return draw_both_sides<false, Texel, Pixel>(span, tile);
        draw_both_sides<true, Texel, Pixel>(span, tile);
    }
}

// Whether a tile's scanlines are drawn at once, all of them or some.
template <class Background>
bool can_follow_tile(const CellPiece<Background>& span)
{
    return span.tile != nullptr && span.length <= kMostSpanPixels &&
           BothSidesScanlines::can_follow(span.origins, span.tile->origins, span.length) &&
           BothSidesScanlines::can_follow(span.directions, span.tile->directions, span.length);
}

// Draws side by side, and checks every texel.
template <class Texel, class Pixel, class Background>
void draw_nine_checked(const CheckedPiece<Background>& span)
{
    LUMI_TALLY(Work::checked_linear, span.length);
    using Sum = TexelSum<Texel, !Background::kIsBlack>;
    SideWalk origins(span.origins);
    SideWalk directions(span.directions);
    uint8_t* pixel = span.pixels;
    for (int32_t k = 0; k < span.length; ++k, pixel += Pixel::kBytes) {
        const SideTaps rows = origins.template taps<Sum::kRowBits>();
        const SideTaps texels = directions.template taps<Sum::kTapBits>();
        uint32_t offset[3];
        for (int n = 0; n < 3; ++n) offset[n] = span.template offset<Texel>(texels.index[n]);
        Sum sum;
        for (int m = 0; m < 3; ++m) {
            const uint8_t* const row = span.row(rows.index[m]);
            if (row == nullptr) continue;
            LUMI_TALLY(Work::checked_row, 1);
            typename Sum::Row of_row;
            for (int n = 0; n < 3; ++n) of_row.add(span.field, row + offset[n] - Sum::kBefore, texels.weight[n]);
            sum.add(of_row, row_weight<Sum>(rows.weight[m]));
        }
        sum.template store<Pixel>(span.background, pixel);
        origins.advance();
        directions.advance();
    }
}

template <>
struct SpanDraw<Linear> {
    template <class Texel, class Pixel, class Background>
    static void draw(CellPiece<Background>& span)
    {
        if (can_follow_tile(span)) return draw_cells<Texel, Pixel>(span, span.tile);
        int32_t scanlines_left = span.scanlines();
        span.go_to_first();
        do {
            if (can_follow(span.origins, span.directions, span.length))
                draw_cells<Texel, Pixel>(span, nullptr);
            else
                draw_steep<Texel, Pixel>(span);
        } while (span.go_down(scanlines_left));
    }
    template <class Texel, class Pixel, class Background>
    static void draw_checked(const CheckedPiece<Background>& span)
    {
        draw_nine_checked<Texel, Pixel>(span);
    }

private:
    // Steps that are too long for halves of words: side by side.
    template <class Texel, class Pixel, class Background>
    static void draw_steep(const CellPiece<Background>& span)
    {
        LatticeLine origins{span.origins, {}, false};
        LatticeLine directions{span.directions, {}, false};
        draw_nine_checked<Texel, Pixel>(
            CheckedPiece<Background>{span.field, span.background, span.pixels, span.length, origins, directions});
    }
};

}  // namespace lumi::detail
