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
#include "lumi/span_kernel.h"

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
          nodes_(camera),
          origins_(field.origins),
          directions_(field.directions),
          front_(origins_, &SpanNode::front),
          back_(directions_, &SpanNode::back)
    {
    }

    void row(const RowSpan& span, int32_t y, uint8_t* pixels)
    {
        if (span.begin >= span.end) return;
        nodes_.begin_row(span.begin, y);
        SpanNode buffer[2];
        SpanNode* at = &buffer[0];
        SpanNode* next = &buffer[1];
        nodes_.evaluate(0, *at);
        front_.begin(*at);
        back_.begin(*at);
        Row row{span.begin, y, pixels};
        int32_t ahead = 0;
        const int32_t last = span.end - span.begin - 1;
        while (ahead <= last) {
            const int32_t length =
                last > ahead ? draw_span(row, *at, *next, ahead, last - ahead) : draw_pixel(row, *at, ahead);
            ahead += length;
            SpanNode* const drawn = at;
            at = next;
            next = drawn;
        }
    }

private:
    using Target = SpanTarget<Background>;

    struct Row {
        int32_t x, y;  // of the first covered pixel
        uint8_t* pixels;
    };

    // Spans double from the left rim and halve towards the right one, so that a span is never much longer than its
    // distance from the rim. from_right > 0.
    int length_log2(int32_t from_left, int32_t from_right) const
    {
        const int32_t to_right = (from_right + 2) / 2;
        const int32_t room = from_left + 2 < to_right ? from_left + 2 : to_right;
        int log2 = span_log2_;
        while ((1 << log2) > room) --log2;
        return log2;
    }

    // Draws the longest span that both lattices allow and sets `next` to the node at its end; returns its length.
    int32_t draw_span(const Row& row, const SpanNode& at, SpanNode& next, int32_t ahead, int32_t from_right)
    {
        for (int log2 = length_log2(ahead, from_right); log2 >= 0;) {
            nodes_.evaluate(ahead + (1 << log2), next);
            int halvings = front_.prepare(at, next, log2);
            if (halvings == 0) halvings = back_.prepare(at, next, log2);
            if (halvings == 0) {
                // The row's last pixel is the last span's end.
                const int32_t length = (1 << log2) == from_right ? from_right + 1 : 1 << log2;
                draw_bent(row, ahead, length, log2);
                front_.commit();
                back_.commit();
                return length;
            }
            log2 -= halvings;
        }
        draw_pixel(row, at, ahead);
        nodes_.evaluate(ahead + 1, next);
        front_.begin(next);
        back_.begin(next);
        return 1;
    }

    // The last pixel of a row, or one next to a cap.
    int32_t draw_pixel(const Row& row, const SpanNode& at, int32_t ahead)
    {
        if (front_.prepare(at, at, 0) == 0 && back_.prepare(at, at, 0) == 0) {
            draw(row, ahead, 1);
        } else {
            draw_exactly(row, ahead, 1);
        }
        return 1;
    }

    // The span that both walkers are prepared for, in two halves where it is curved.
    void draw_bent(const Row& row, int32_t ahead, int32_t length, int log2)
    {
        const bool allowed = !front_.side().in_cap && !back_.side().in_cap;
        const bool front_bent = front_.bend(log2, allowed);
        const bool back_bent = back_.bend(log2, allowed);
        if (!front_bent && !back_bent) return draw(row, ahead, length);
        const int32_t half = (1 << log2) / 2;
        draw(row, ahead, half);
        front_.second_half(half);
        back_.second_half(half);
        draw(row, ahead + half, length - half);
    }

    void draw(const Row& row, int32_t ahead, int32_t length) const
    {
        if (rows_present(front_.side(), length)) {
            uint8_t* const pixels = row.pixels + static_cast<uint32_t>(ahead) * Pixel::kBytes;
            const Target target = {field_,        background_, pixels,        length,
                                   row.x + ahead, row.y,       front_.side(), back_.side()};
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
        } else {
            draw_exactly(row, ahead, length);
        }
    }

    void draw_exactly(const Row& row, int32_t ahead, int32_t length) const
    {
        const RowSpan span = {row.x + ahead, row.x + ahead + length};
        draw_exact<Reconstruction, Texel, Pixel>(field_, camera_, background_, span, row.y,
                                                 row.pixels + static_cast<uint32_t>(ahead) * Pixel::kBytes);
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
    RowNodes nodes_;
    SpanLattice origins_;
    SpanLattice directions_;
    SpanWalker front_;
    SpanWalker back_;
};

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
