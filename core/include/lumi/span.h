// SPDX-License-Identifier: MIT
// The fast renderer: exact hits every few pixels, lattice coordinates stepped in between.
//
//     render_spans<Linear, TexelRgb565, PixelRgb565Swapped>(field, camera, OverBlack{}, stripe, 16);
//
// The same contract as render(): any rectangle, any order, re-entrant. `span_px` (1, 2, 4, 8 or 16) is the most pixels
// between exact hits: the trade of speed for accuracy that docs/tradeoff.md measures. Next to the sphere's rim, where
// hits turn fast, spans are shorter.
#pragma once

#include "lumi/outline.h"
#include "lumi/render.h"
#include "lumi/span_draw.h"

namespace lumi
{

// Draws one row's covered span after another from one stripe's constants.
template <class Reconstruction, class Texel, class Pixel, class Background>
class SpanRenderer
{
public:
    SpanRenderer(const Field& field, const Camera& camera, const Background& background, int span_log2)
        : field_(field),
          camera_(camera),
          background_(background),
          span_log2_(span_log2),
          origins_(field.origins),
          directions_(field.directions)
    {
    }

    void row(const RowSpan& span, int32_t y, uint8_t* pixels)
    {
        if (span.begin >= span.end) return;
        const RowNodes nodes(camera_, span.begin, y);
        SpanWalker front(origins_);
        SpanWalker back(directions_);
        const SpanNode first = nodes.at(0);
        front.begin(first.front);
        back.begin(first.back);
        const int32_t last = span.end - span.begin - 1;
        Target target(field_, background_);
        target.y = y;
        target.pixels = pixels;
        for (int32_t at = 0; at <= last; at += target.length) {
            target.x = span.begin + at;
            target.length = prepare(nodes, front, back, at, last - at, target);
            draw(target);
            target.pixels += static_cast<uint32_t>(target.length) * Pixel::kBytes;
        }
    }

private:
    using Target = SpanTarget<Background>;

    // Spans double from the left rim and halve towards the right one.
    int length_log2(int32_t from_left, int32_t from_right) const
    {
        int log2 = 0;
        const int32_t room = from_left + 2 < from_right ? from_left + 2 : from_right;
        while (log2 < span_log2_ && (2 << log2) <= room) ++log2;
        while ((1 << log2) > from_right) --log2;
        return log2;
    }

    // Sets both sides for the longest span that both lattices allow; returns its length.
    int32_t prepare(const RowNodes& nodes, SpanWalker& front, SpanWalker& back, int32_t at, int32_t left,
                    Target& target) const
    {
        target.exact = false;
        for (int log2 = left > 0 ? length_log2(at, left) : -1; log2 >= 0;) {
            const SpanNode next = nodes.at(at + (1 << log2));
            int halvings = front.prepare(next.front, log2, target.origins);
            if (halvings == 0) halvings = back.prepare(next.back, log2, target.directions);
            if (halvings == 0) {
                front.commit();
                back.commit();
                return 1 << log2;
            }
            log2 -= halvings;
        }
        target.exact = !front.prepare_pixel(target.origins) || !back.prepare_pixel(target.directions);
        if (left > 0) {
            const SpanNode next = nodes.at(at + 1);
            front.begin(next.front);
            back.begin(next.back);
        }
        return 1;
    }

    void draw(const Target& target) const
    {
        if (!target.exact && rows_present(target.origins, target.length)) {
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
        } else {
            draw_exact<Reconstruction, Texel, Pixel>(
                field_, camera_, background_, RowSpan{target.x, target.x + target.length}, target.y, target.pixels);
        }
    }

    bool rows_present(const SpanSide& side, int32_t length) const
    {
        return field_.used_origins == field_.origins.size() ||
               side.highest(length) < static_cast<int32_t>(field_.used_origins);
    }

    const Field& field_;
    const Camera& camera_;
    const Background& background_;
    int span_log2_;
    SpanLattice origins_;
    SpanLattice directions_;
};

inline bool fits_spans(const Lattice& lattice)
{
    return lattice.size() >= kMinSpanLattice && lattice.size() <= kMaxSpanLattice;
}

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError render_spans(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe,
                         int32_t span_px)
{
    if (field.texel_format != Texel::kFormat) return RenderError::wrong_texel_format;
    int span_log2 = 0;
    while (span_log2 < kMaxSpanLog2 && (2 << span_log2) <= span_px) ++span_log2;
    if (span_log2 == 0 || !fits_spans(field.origins) || !fits_spans(field.directions)) {
        return render<Reconstruction, Texel, Pixel>(field, camera, background, stripe);
    }
    SpanRenderer<Reconstruction, Texel, Pixel, Background> renderer(field, camera, background, span_log2);
    OutlineTracker outline(camera, {stripe.x_px, stripe.x_px + stripe.width_px});
    for (int32_t row = 0; row < stripe.height_px; ++row) {
        uint8_t* pixels = stripe.pixels + static_cast<size_t>(row) * stripe.stride_bytes;
        const RowSpan span = outline.row(stripe.y_px + row);
        fill_beside<Pixel>(background, stripe, span, pixels);
        renderer.row(span, stripe.y_px + row, pixels + static_cast<uint32_t>(span.begin - stripe.x_px) * Pixel::kBytes);
    }
    return RenderError::none;
}

}  // namespace lumi
