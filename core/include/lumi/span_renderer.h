// SPDX-License-Identifier: MIT
// Draws one stripe of spans: tiles where the sphere's inside allows them, rows of spans in what is left.
#pragma once

#include "lumi/outline.h"
#include "lumi/render.h"
#include "lumi/span_draw.h"
#include "lumi/span_ramp.h"
#include "lumi/span_tile.h"
#include "lumi/span_walker.h"

namespace lumi
{

template <class Reconstruction, class Texel, class Pixel, class Background>
class SpanRenderer
{
public:
    SpanRenderer(const Field& field, const Camera& camera, const Background& background, const Stripe& stripe,
                 int span_log2)
        : field_(field),
          camera_(camera),
          background_(background),
          stripe_(stripe),
          span_log2_(span_log2),
          outline_(camera, {stripe.x_px, stripe.x_px + stripe.width_px}),
          nodes_(camera),
          origins_(field.origins),
          directions_(field.directions),
          front_track_(origins_, &SpanNode::front),
          back_track_(directions_, &SpanNode::back),
          front_(front_track_),
          back_(back_track_),
          front_tile_(front_track_),
          back_tile_(back_track_),
          ramp_(1 << span_log2)
    {
    }

    void draw()
    {
        const int32_t end = stripe_.y_px + stripe_.height_px;
        for (int32_t y = stripe_.y_px; y < end;) {
            const int32_t next = (y | (kTileRows - 1)) + 1;
            draw_band(y, next < end ? next : end);
            y = next;
        }
    }

private:
    using Target = SpanTarget<Background>;

    uint8_t* pixel_at(int32_t x, int32_t y) const
    {
        return stripe_.pixels + static_cast<size_t>(y - stripe_.y_px) * stripe_.stride_bytes +
               static_cast<uint32_t>(x - stripe_.x_px) * Pixel::kBytes;
    }

    // Rows from y to before end, all of one row of tiles.
    void draw_band(int32_t y, int32_t end)
    {
        y_ = y;
        rows_ = end - y;
        bool covered = false;
        for (int32_t row = 0; row < rows_; ++row) {
            spans_[row] = outline_.row(y + row);
            covered = covered || spans_[row].begin < spans_[row].end;
            fill_beside<Pixel>(background_, stripe_, spans_[row], pixel_at(stripe_.x_px, y + row));
        }
        if (!covered) return;
        gaps_ = 0;
        gap_[0] = {INT32_MIN, INT32_MAX};
        if (span_log2_ >= kMinTileLog2) draw_tiles();
        for (int k = 0; k <= gaps_; ++k) draw_between(gap_[k].begin, gap_[k].end);
    }

    // Draws the band's tiles and lists what they leave.
    void draw_tiles()
    {
        constexpr int32_t kMargin = kTileRows / 2;
        const int32_t top = y_ & -kTileRows;
        const int32_t bottom = top + kTileRows;
        const int32_t below = camera_.height_px - 1;
        if (top < 0 || bottom > below) return;
        const int32_t above_top = top > kMargin ? top - kMargin : 0;
        const int32_t below_bottom = bottom + kMargin < below ? bottom + kMargin : below;
        const RowSpan inside = outline_.columns(above_top, below_bottom, spans_[0], kMinTileLog2 - 1);
        constexpr int32_t kStep = 1 << kMinTileLog2;
        const int32_t begin = (inside.begin + kStep - 1) & -kStep;
        const int32_t end = inside.end & -kStep;
        if (begin >= end) return;
        const RayRow rows[] = {nodes_.row_at(begin, top), nodes_.row_at(begin, top + kTileRows / 2),
                               nodes_.row_at(begin, bottom)};
        SpanNode corners[2][2];
        SpanNode centre;
        int left = 0;
        nodes_.evaluate(rows[0], 0, corners[0][left]);
        nodes_.evaluate(rows[2], 0, corners[1][left]);
        for (int32_t x = begin; x < end;) {
            int log2 = span_log2_;
            while ((x & ((1 << log2) - 1)) != 0 || x + (1 << log2) > end) --log2;
            const int right = 1 - left;
            const TileCorners tile = {&corners[0][left], &corners[0][right], &corners[1][left], &corners[1][right],
                                      &centre};
            bool fits = false;
            for (++log2; !fits && log2 > kMinTileLog2;) {
                --log2;
                const int32_t width = 1 << log2;
                nodes_.evaluate(rows[0], x + width - begin, corners[0][right]);
                nodes_.evaluate(rows[1], x + width / 2 - begin, centre);
                nodes_.evaluate(rows[2], x + width - begin, corners[1][right]);
                fits = front_tile_.prepare(tile, log2) && back_tile_.prepare(tile, log2) &&
                       (all_baked() || is_baked(front_tile_.highest(width)));
            }
            if (fits && note_tile(x, 1 << log2)) draw_tile(x, 1 << log2);
            left = right;
            x += 1 << log2;
        }
    }

    // Takes a tile's columns from the last gap; false where there is no room to note another gap.
    bool note_tile(int32_t x, int32_t width)
    {
        if (gap_[gaps_].begin != x) {
            if (gaps_ + 1 == kMaxGaps) return false;
            gap_[gaps_].end = x;
            ++gaps_;
        }
        gap_[gaps_] = {x + width, INT32_MAX};
        return true;
    }

    void draw_tile(int32_t x, int32_t width)
    {
        Target target = {field_, background_, pixel_at(x, y_), width, x, y_, front_tile_.side(), back_tile_.side()};
        for (int32_t rows = y_ & (kTileRows - 1); target.y < y_ + rows_; rows = 1) {
            front_tile_.advance(rows);
            back_tile_.advance(rows);
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
            ++target.y;
            target.pixels += stripe_.stride_bytes;
        }
    }

    // Draws what the band's rows cover from column `from` to before `to`.
    void draw_between(int32_t from, int32_t to)
    {
        for (int32_t row = 0; row < rows_; ++row) {
            const RowSpan& span = spans_[row];
            const RowSpan part = {from > span.begin ? from : span.begin, to < span.end ? to : span.end};
            if (part.begin < part.end) draw_row(span, part, y_ + row);
        }
    }

    void draw_row(const RowSpan& span, const RowSpan& part, int32_t y)
    {
        row_ = {span, part, nodes_.row_at(part.begin, y), y};
        SpanNode buffer[2];
        SpanNode* at = &buffer[0];
        SpanNode* next = &buffer[1];
        nodes_.evaluate(row_.rays, 0, *at);
        front_.begin(*at);
        back_.begin(*at);
        for (int32_t x = part.begin; x < part.end;) {
            x += x + 1 < span.end ? draw_span(*at, *next, x) : draw_pixel(*at, x);
            SpanNode* const drawn = at;
            at = next;
            next = drawn;
        }
    }

    // Draws the longest span that both lattices allow and sets `next` to the node at its end; returns its length.
    int32_t draw_span(const SpanNode& at, SpanNode& next, int32_t x)
    {
        const int32_t from_left = x - row_.span.begin;
        const int32_t from_right = row_.span.end - 1 - x;
        for (int32_t length = ramp_.length(from_left, from_right, row_.part.end - x); length > 0;) {
            nodes_.evaluate(row_.rays, x - row_.part.begin + length, next);
            int32_t fits = front_.prepare(at, next, length);
            if (fits == length) fits = back_.prepare(at, next, length);
            if (fits == length) {
                const int32_t share = SpanRamp::shift_q8(from_left, from_right - length, length);
                if (share != 0) {
                    front_.shift(share);
                    back_.shift(share);
                }
                // The row's last pixel is the last span's end.
                const int32_t drawn = length == from_right ? length + 1 : length;
                draw(front_.side(), back_.side(), x, row_.y, drawn);
                front_.commit();
                back_.commit();
                return drawn;
            }
            length = fits;
        }
        draw_pixel(at, x);
        nodes_.evaluate(row_.rays, x - row_.part.begin + 1, next);
        front_.begin(next);
        back_.begin(next);
        return 1;
    }

    // The last pixel of a row, or one next to a cap.
    int32_t draw_pixel(const SpanNode& at, int32_t x)
    {
        if (front_.prepare(at, at, 1) == 1 && back_.prepare(at, at, 1) == 1) {
            draw(front_.side(), back_.side(), x, row_.y, 1);
        } else {
            draw_exactly(x, row_.y, 1);
        }
        return 1;
    }

    void draw(const SpanSide& front, const SpanSide& back, int32_t x, int32_t y, int32_t length) const
    {
        if (all_baked() || is_baked(front.highest(length))) {
            const Target target = {field_, background_, pixel_at(x, y), length, x, y, front, back};
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
        } else {
            draw_exactly(x, y, length);
        }
    }

    void draw_exactly(int32_t x, int32_t y, int32_t length) const
    {
        draw_exact<Reconstruction, Texel, Pixel>(field_, camera_, background_, {x, x + length}, y, pixel_at(x, y));
    }

    bool all_baked() const { return field_.used_origins == field_.origins.size(); }
    bool is_baked(int32_t origin) const { return origin < static_cast<int32_t>(field_.used_origins); }

    static constexpr int kMinTileLog2 = 3;
    static constexpr int kMaxGaps = 6;  // both rims, two poles in front and two behind

    const Field& field_;
    const Camera& camera_;
    const Background& background_;
    const Stripe& stripe_;
    int span_log2_;
    OutlineTracker outline_;
    NodeEvaluator nodes_;
    SpanLattice origins_;
    SpanLattice directions_;
    SpanTrack front_track_, back_track_;
    SpanWalker front_;
    SpanWalker back_;
    TileWalker front_tile_;
    TileWalker back_tile_;
    SpanRamp ramp_;
    int32_t y_ = 0, rows_ = 0;  // of the band
    RowSpan spans_[kTileRows];
    RowSpan gap_[kMaxGaps];  // columns without tiles, 0 .. gaps_, from left to right
    int gaps_ = 0;
    struct {
        RowSpan span, part;  // what the row covers, and what of it is drawn
        RayRow rays;
        int32_t y;
    } row_{};
};

}  // namespace lumi
