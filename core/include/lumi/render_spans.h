// SPDX-License-Identifier: MIT
// The fast renderer: exact hits every few pixels, lattice coordinates linear in between.
//
//     render_spans<Linear, TexelRgb565, PixelRgb565Swapped>(field, camera, OverBlack{}, stripe, 16);
//
// The same contract as render(): any rectangle, any order, re-entrant. `span_px` (1, 2, 4, 8 or 16) is the most pixels
// between exact hits: the trade of speed for accuracy that docs/tradeoff.md measures. From 8 on, the inside of the
// sphere is drawn in tiles of span_px × 8 pixels. Next to the rim, where hits turn fast, spans are shorter.
#pragma once

#include "lumi/detail/chord/kernel/kernel.h"
#include "lumi/detail/chord/renderer.h"

namespace lumi
{

inline bool fits_spans(const Lattice& lattice)
{
    return lattice.size() >= kMinSpanLattice && lattice.size() <= kMaxSpanLattice;
}

// Texels and palette entries are read in one access each: they lie at multiples of their size. Any field at an address
// divisible by 4 does, if its row stride is even.
inline bool spans_can_read(const Field& field)
{
    const auto aligned = [](const uint8_t* p, uintptr_t to) { return reinterpret_cast<uintptr_t>(p) % to == 0; };
    if (field.texel_format == format::TexelFormat::rgb565)
        return aligned(field.texels, 2) && field.row_stride_bytes % 2 == 0;
    return field.texel_format != format::TexelFormat::palette8 || aligned(field.palette, 4);
}

// Fields that spans cannot draw (see kMaxSpanLattice, kMinSpanLattice, spans_can_read) are drawn by render().
template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError render_spans(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe,
                         int32_t span_px)
{
    if (field.texel_format != Texel::kFormat) return RenderError::wrong_texel_format;
    int span_log2 = 0;
    while (span_log2 < kMaxSpanLog2 && (2 << span_log2) <= span_px) ++span_log2;
    if (span_log2 == 0 || !fits_spans(field.origins) || !fits_spans(field.directions) || !spans_can_read(field)) {
        return render<Reconstruction, Texel, Pixel>(field, camera, background, stripe);
    }
    SpanRenderer<Reconstruction, Texel, Pixel, Background> renderer(field, camera, background, stripe, span_log2);
    renderer.draw();
    return RenderError::none;
}

}  // namespace lumi
