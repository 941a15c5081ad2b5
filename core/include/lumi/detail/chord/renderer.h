// SPDX-License-Identifier: MIT
// Draws one stripe of spans: tiles where the sphere's inside allows them, rows of spans in what is left.
#pragma once

#include "lumi/detail/stepping/outline.h"
#include "lumi/render.h"
#include "lumi/detail/chord/loops.h"
#include "lumi/detail/stepping/span_length.h"
#include "lumi/detail/chord/rim.h"
#include "lumi/detail/chord/tile.h"
#include "lumi/detail/stepping/walker.h"

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

    // A RowSpan in half the space.
    struct Columns {
        int16_t begin, end;

        static Columns of(const RowSpan& span)
        {
            static_assert(kMaxImageSide <= INT16_MAX);
            return {static_cast<int16_t>(span.begin), static_cast<int16_t>(span.end)};
        }
        RowSpan span() const { return {begin, end}; }
    };

    // Both lattices, through a row's spans or a row of tiles.
    template <class Walker>
    struct Walkers {
        Walker front, back;

        explicit Walkers(SpanRenderer& r) : front(r.front_track_), back(r.back_track_) {}
    };

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
        const int32_t top = y & -kTileRows;
        if (has_tiles() && y != top) edge_[0] = Columns::of(outline_.row(top));
        bool covered = false;
        for (int32_t row = 0; row < rows_; ++row) {
            spans_[row] = y + row == below_y_ ? edge_[1] : Columns::of(outline_.row(y + row));
            covered = covered || spans_[row].begin < spans_[row].end;
            fill_beside<Pixel>(background_, stripe_, spans_[row].span(), pixel_at(stripe_.x_px, y + row));
        }
        if (!covered) return;
        gaps_ = 0;
        gap_[0] = {INT16_MIN, INT16_MAX};
        if (has_tiles()) draw_tiles();
        if (gaps_ > 0) {
            if (y == top) edge_[0] = spans_[0];
            below_y_ = top + kTileRows;
            edge_[1] = Columns::of(outline_.row(below_y_));
        }
        for (int k = 0; k <= gaps_; ++k) {
            const bool rim = gaps_ > 0 && (k == 0 || k == gaps_);
            if (!rim || !draw_rim(gap_[k])) draw_between(gap_[k]);
        }
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
        const RowSpan inside = outline_.columns(above_top, below_bottom, spans_[0].span(), kMinTileLog2 - 1);
        constexpr int32_t kStep = 1 << kMinTileLog2;
        const int32_t begin = (inside.begin + kStep - 1) & -kStep;
        const int32_t end = inside.end & -kStep;
        if (begin >= end) return;
        const RayRow first = nodes_.row_at(begin, top);
        const RayRow rows[] = {first, nodes_.moved(first, 0, kTileRows / 2), nodes_.moved(first, 0, kTileRows)};
        Walkers<TileWalker> walkers(*this);
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
                fits = walkers.front.prepare(tile, log2) && walkers.back.prepare(tile, log2) &&
                       (all_baked() || is_baked(walkers.front.highest(width)));
            }
            if (fits && note_tile(x, 1 << log2)) draw_tile(walkers, x, 1 << log2);
            left = right;
            x += 1 << log2;
        }
    }

    // Takes a tile's columns from the last gap; false where there is no room to note another gap.
    bool note_tile(int32_t x, int32_t width)
    {
        if (gap_[gaps_].begin != x) {
            if (gaps_ + 1 == kMaxGaps) return false;
            gap_[gaps_].end = static_cast<int16_t>(x);
            ++gaps_;
        }
        gap_[gaps_] = {static_cast<int16_t>(x + width), INT16_MAX};
        return true;
    }

    void draw_tile(Walkers<TileWalker>& walkers, int32_t x, int32_t width)
    {
        SpanSide& front = walkers.front.side();
        SpanSide& back = walkers.back.side();
        Target target = {field_, background_, pixel_at(x, y_), width, x, y_, front, back, nullptr};
        const int32_t first = y_ & (kTileRows - 1);
        if (!target.is_over_cap()) {
            const TileRows rows = {first, rows_, stripe_.stride_bytes, walkers.front.down(), walkers.back.down()};
            target.tile = &rows;
            return SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
        }
        for (int32_t rows = first; target.y < y_ + rows_; rows = 1) {
            walkers.front.advance(rows);
            walkers.back.advance(rows);
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
            ++target.y;
            target.pixels += stripe_.stride_bytes;
        }
    }

    // Draws one of both gaps between the outline and the tiles from exact hits of two rows; false where there are none.
    // Not inlined: what it keeps on the stack ends with it.
    __attribute__((noinline)) bool draw_rim(const Columns& gap)
    {
        SpanRim rim(front_track_, back_track_);
        const int32_t inner = gap.begin == INT16_MIN ? gap.end : gap.begin;
        const RayRow rays = nodes_.row_at(inner, y_ & -kTileRows);
        if (!prepare_rim(gap, rays, rim)) return false;
        const int32_t first = y_ & (kTileRows - 1);
        for (int32_t row = 0; row < rows_; ++row) {
            const RowSpan part = part_of(gap, spans_[row]);
            if (part.begin >= part.end) continue;
            row_ = {spans_[row].span(), part, nodes_.moved(rays, part.begin - inner, first + row), y_ + row};
            rim.begin_row(first + row, nodes_.half_chord_q15(row_.rays, 0));
            for (int32_t x = part.begin; x < part.end;) x += draw_rim_span(rim, x);
        }
        return true;
    }

    // `rays` begin at the gap's border to the tiles, in their first row.
    bool prepare_rim(const Columns& gap, const RayRow& rays, SpanRim& rim) const
    {
        const bool left = gap.begin == INT16_MIN;
        int32_t outer_px[2];
        for (int k = 0; k < 2; ++k) {
            const Columns& edge = edge_[k];
            if (edge.begin >= edge.end || !outline_.is_outline(left ? edge.begin : edge.end)) return false;
            outer_px[k] = left ? edge.begin - gap.end : edge.end - 1 - gap.begin;
        }
        return rim.prepare(nodes_, rays, outer_px);
    }

    // Returns how many pixels it drew.
    int32_t draw_rim_span(SpanRim& rim, int32_t x)
    {
        const int32_t from_left = x - row_.span.begin;
        const int32_t from_right = row_.span.end - 1 - x;
        const int32_t rest = row_.part.end - x;
        const int32_t half = 1 << (span_log2_ - 1);
        const int32_t room = rim.turns_far() && half < rest ? half : rest;
        const int32_t length = from_right > 0 ? ramp_.length(from_left, from_right, room) : 0;
        const int32_t half_chord_q15 = nodes_.half_chord_q15(row_.rays, x - row_.part.begin + length);
        rim.prepare_span(half_chord_q15, length > 0 ? length : 1,
                         SpanRamp::shift_q8(from_left, from_right - length, length));
        // The row's last pixel is the last span's end.
        const int32_t drawn = length == from_right ? length + 1 : length;
        draw(front_track_.side, back_track_.side, x, row_.y, drawn);
        return drawn;
    }

    static RowSpan part_of(const Columns& gap, const Columns& span)
    {
        return {gap.begin > span.begin ? gap.begin : span.begin, gap.end < span.end ? gap.end : span.end};
    }

    // Draws what the band's rows cover of a gap.
    void draw_between(const Columns& gap)
    {
        for (int32_t row = 0; row < rows_; ++row) {
            const RowSpan part = part_of(gap, spans_[row]);
            if (part.begin < part.end) draw_row(spans_[row].span(), part, y_ + row);
        }
    }

    void draw_row(const RowSpan& span, const RowSpan& part, int32_t y)
    {
        row_ = {span, part, nodes_.row_at(part.begin, y), y};
        SpanNode buffer[2];
        SpanNode* at = &buffer[0];
        SpanNode* next = &buffer[1];
        Walkers<SpanWalker> walkers(*this);
        nodes_.evaluate(row_.rays, 0, *at);
        walkers.front.begin(*at);
        walkers.back.begin(*at);
        for (int32_t x = part.begin; x < part.end;) {
            x += x + 1 < span.end ? draw_span(walkers, *at, *next, x) : draw_pixel(walkers, *at, x);
            SpanNode* const drawn = at;
            at = next;
            next = drawn;
        }
    }

    // Draws the longest span that both lattices allow and sets `next` to the node at its end; returns its length.
    int32_t draw_span(Walkers<SpanWalker>& walkers, const SpanNode& at, SpanNode& next, int32_t x)
    {
        const int32_t from_left = x - row_.span.begin;
        const int32_t from_right = row_.span.end - 1 - x;
        for (int32_t length = ramp_.length(from_left, from_right, row_.part.end - x); length > 0;) {
            nodes_.evaluate(row_.rays, x - row_.part.begin + length, next);
            int32_t fits = walkers.front.prepare(at, next, length);
            if (fits == length) fits = walkers.back.prepare(at, next, length);
            if (fits == length) {
                const int32_t share = SpanRamp::shift_q8(from_left, from_right - length, length);
                if (share != 0) {
                    walkers.front.shift(share);
                    walkers.back.shift(share);
                }
                // The row's last pixel is the last span's end.
                const int32_t drawn = length == from_right ? length + 1 : length;
                draw(walkers.front.side(), walkers.back.side(), x, row_.y, drawn);
                walkers.front.commit();
                walkers.back.commit();
                return drawn;
            }
            length = fits;
        }
        draw_pixel(walkers, at, x);
        nodes_.evaluate(row_.rays, x - row_.part.begin + 1, next);
        walkers.front.begin(next);
        walkers.back.begin(next);
        return 1;
    }

    // The last pixel of a row, or one next to a cap.
    int32_t draw_pixel(Walkers<SpanWalker>& walkers, const SpanNode& at, int32_t x)
    {
        if (walkers.front.prepare(at, at, 1) == 1 && walkers.back.prepare(at, at, 1) == 1) {
            draw(walkers.front.side(), walkers.back.side(), x, row_.y, 1);
        } else {
            draw_exactly(x, row_.y, 1);
        }
        return 1;
    }

    void draw(SpanSide& front, SpanSide& back, int32_t x, int32_t y, int32_t length) const
    {
        if (all_baked() || is_baked(front.highest(length))) {
            Target target = {field_, background_, pixel_at(x, y), length, x, y, front, back, nullptr};
            SpanDraw<Reconstruction>::template draw<Texel, Pixel>(target);
        } else {
            draw_exactly(x, y, length);
        }
    }

    void draw_exactly(int32_t x, int32_t y, int32_t length) const
    {
        draw_exact<Reconstruction, Texel, Pixel>(field_, camera_, background_, {x, x + length}, y, pixel_at(x, y));
    }

    bool has_tiles() const { return span_log2_ >= kMinTileLog2; }
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
    SpanRamp ramp_;
    int32_t y_ = 0, rows_ = 0;  // of the band
    Columns spans_[kTileRows];
    Columns edge_[2] = {};         // of the tiles' first row and the one below their last ...
    int32_t below_y_ = INT32_MIN;  // ... which is this one
    Columns gap_[kMaxGaps];        // columns without tiles, 0 .. gaps_, from left to right
    int gaps_ = 0;
    struct {
        RowSpan span, part;  // what the row covers, and what of it is drawn
        RayRow rays;
        int32_t y;
    } row_{};
};

}  // namespace lumi
