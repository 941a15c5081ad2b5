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

inline constexpr int kMaxSpanLog2 = 4;

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
        for (int32_t at = 0; at < last;) {
            const int log2 = length_log2(at, last - at);
            const SpanNode next = nodes.at(at + (1 << log2));
            draw({front, back, next, log2, span.begin + at, y, pixels + static_cast<uint32_t>(at) * Pixel::kBytes});
            at += 1 << log2;
        }
        exact(span.end - 1, 1, y, pixels + static_cast<uint32_t>(last) * Pixel::kBytes);
    }

private:
    struct Step {
        SpanWalker& front;
        SpanWalker& back;
        const SpanNode& next;
        int log2;
        int32_t x, y;
        uint8_t* pixels;
    };

    // Spans double from the left rim and halve towards the right one.
    int length_log2(int32_t from_left, int32_t from_right) const
    {
        int log2 = 0;
        const int32_t room = from_left + 2 < from_right ? from_left + 2 : from_right;
        while (log2 < span_log2_ && (2 << log2) <= room) ++log2;
        while ((1 << log2) > from_right) --log2;
        return log2;
    }

    void draw(const Step& step)
    {
        const int32_t length = 1 << step.log2;
        SpanTarget<Background> target{field_, background_, step.pixels, length, step.x, step.y, {}, {}};
        const bool origins_drawn = step.front.advance(step.next.front, step.log2, target.origins);
        const bool directions_drawn = step.back.advance(step.next.back, step.log2, target.directions);
        if (origins_drawn && directions_drawn && rows_present(target.origins, length)) {
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
        } else {
            exact(step.x, length, step.y, step.pixels);
        }
    }

    bool rows_present(const SpanSide& side, int32_t length) const
    {
        return field_.used_origins == field_.origins.size() ||
               side.highest(length) < static_cast<int32_t>(field_.used_origins);
    }

    void exact(int32_t x, int32_t length, int32_t y, uint8_t* pixels) const
    {
        draw_exact<Reconstruction, Texel, Pixel>(field_, camera_, background_, RowSpan{x, x + length}, y, pixels);
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
