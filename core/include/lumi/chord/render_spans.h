// SPDX-License-Identifier: MIT
// The fast renderer computes exact hits every few pixels, and lattice coordinates are linear in between.
//
//     render_spans<Linear, TexelRgb565, PixelRgb565Swapped>(field, camera, OverBlack{}, stripe, 16);
//
// It keeps render()'s contract: any rectangle, any order, re-entrant, and any rectangle shows the same pixels as any
// other. Full scanlines are the cheapest: of a rectangle that begins right of the sphere's left outline, hits on the
// way from there are evaluated, too. `span_px` (2, 4, 8 or 16) is the most pixels between exact hits: the trade of
// speed for accuracy that docs/tradeoff.md measures. From 8 on, the inside of the sphere is drawn in tiles of
// span_px × 8 pixels. Next to the rim, where hits turn fast, spans are shorter. It
// draws by Nearest and Linear; Paper<K> is drawn by render() alone.
#pragma once
#pragma GCC system_header

#include "lumi/chord/detail/linear.h"
#include "lumi/chord/detail/one_tap.h"
#include "lumi/chord/render.h"

namespace lumi
{

// Tells whether render_spans() draws a field; render() draws all. It takes lattices of kMinSpanLattice to
// kMaxSpanLattice points, whose texels and palette entries lie at multiples of their size, as they are read in one
// access each. Any field at an address divisible by 4 has that, if its row stride is even.
inline bool fits_spans(const Field& field)
{
    const auto has_zones = [](const detail::Lattice& l) {
        return l.size() >= detail::kMinSpanLattice && l.size() <= detail::kMaxSpanLattice;
    };
    const auto aligned = [](const uint8_t* p, uintptr_t to) { return reinterpret_cast<uintptr_t>(p) % to == 0; };
    if (!has_zones(field.origins) || !has_zones(field.directions)) return false;
    if (field.texel_format == TexelFormat::rgb565) return aligned(field.texels, 2) && field.row_stride_bytes % 2 == 0;
    return field.texel_format != TexelFormat::palette8 || aligned(field.palette, 4);
}

}  // namespace lumi

namespace lumi::detail
{

// Each of the loops has a frame of its own: what they keep on the stack ends before the next piece is set up.
template <class Reconstruction, class Texel, class Pixel, class Background>
struct PieceLoops {
    __attribute__((noinline)) static void draw(CellPiece<Background> piece)
    {
        SpanDraw<Reconstruction>::template draw<Texel, Pixel>(piece);
    }
    __attribute__((noinline)) static void draw_checked(const CheckedPiece<Background>& piece)
    {
        SpanDraw<Reconstruction>::template draw_checked<Texel, Pixel>(piece);
    }
};

}  // namespace lumi::detail

namespace lumi
{

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError render_spans(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe,
                         int32_t span_px)
{
    if (field.texel_format != Texel::kFormat) return RenderError::wrong_texel_format;
    if (!fits_spans(field)) return RenderError::unfit_for_spans;
    int span_log2 = 1;
    while (span_log2 < detail::kMaxSpanLog2 && (2 << span_log2) <= span_px) ++span_log2;
    using Loops = detail::PieceLoops<Reconstruction, Texel, Pixel, Background>;
    detail::ChordStepper stepper(field, camera, stripe, span_log2);
    detail::LatticeLine& origins = stepper.origins();
    detail::LatticeLine& directions = stepper.directions();
    alignas(4) uint8_t cut[detail::kMostPiecePixels * Pixel::kBytes] = {};
    for (detail::Piece piece; stepper.next(piece);) {
        if (piece.kind == detail::Piece::Kind::scanline) {
            detail::fill_beside<Pixel>(background, stripe, {piece.x, piece.x + piece.width}, piece.y);
            continue;
        }
        const bool is_in_part = detail::is_cut(stripe, piece);
        if (is_in_part) detail::copy_from_stripe(stripe, piece, Pixel::kBytes, cut);
        uint8_t* const pixels = is_in_part ? cut : pixel_of<Pixel>(stripe, piece.x, piece.y);
        if (piece.kind == detail::Piece::Kind::cells)
            Loops::draw({field, background, pixels, piece.width, origins.cells, directions.cells, piece.tile});
        else
            Loops::draw_checked({field, background, pixels, piece.width, origins, directions});
        if (is_in_part) copy_into_stripe(stripe, piece, Pixel::kBytes, cut);
    }
    return RenderError::none;
}

}  // namespace lumi
