// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/stepper.h"

namespace lumi::detail
{
namespace
{

Extent common(const Extent& a, const Extent& b)
{
    return {a.begin > b.begin ? a.begin : b.begin, a.end < b.end ? a.end : b.end};
}

// Where to look for the sphere: nowhere if none of the image's columns is shown.
Extent columns_of(const Camera& camera, const Extent& shown)
{
    const Extent all = {0, camera.width_px()}, visible = common(all, shown);
    return visible.begin < visible.end ? all : Extent{0, 0};
}

}  // namespace

ChordStepper::ChordStepper(const Field& field, const Camera& camera, const Stripe& stripe, int span_log2)
    : field_(field),
      camera_(camera),
      span_log2_(span_log2),
      shown_{stripe.x_px, stripe.right_px()},
      outline_(camera, columns_of(camera, shown_)),
      hits_(camera),
      origins_(field.origins),
      directions_(field.directions),
      front_track_(origins_, &HitPair::front),
      back_track_(directions_, &HitPair::back),
      front_tile_(front_track_),
      back_tile_(back_track_),
      front_walker_(front_track_),
      back_walker_(back_track_),
      lengths_(1 << span_log2),
      next_y_(stripe.y_px),
      end_y_(stripe.bottom_px()),
      tile_scanlines_{0, 0, stripe.stride_bytes, front_tile_.down(), back_tile_.down()}
{
}

bool ChordStepper::next(Piece& piece)
{
    for (;;) {
        switch (stage_) {
            case Stage::band:
                if (!begin_band()) return false;
                stage_ = Stage::scanlines;
                break;
            case Stage::scanlines:
                if (scanline_ < scanlines_) {
                    const Extent& span = spans_[scanline_];
                    piece = {Piece::Kind::scanline, span.begin, y_ + scanline_, span.end - span.begin, nullptr};
                    ++scanline_;
                    return true;
                }
                stage_ = begin_tiles() ? Stage::tiles : Stage::spans;
                break;
            case Stage::tiles:
                if (next_tile(piece)) {
                    const int32_t end = piece.x + piece.width;
                    const bool is_whole = piece.x >= shown_.begin && end <= shown_.end;
                    stage_ = is_whole || !is_shown(piece.x, end) ? Stage::spans : Stage::cut_tile;
                    if (is_whole) return true;
                    cut_scanline_ = 0;
                    break;
                }
                begin_gap(drawn_x_, INT32_MAX);
                stage_ = Stage::spans;
                break;
            case Stage::cut_tile:
                if (next_cut_scanline(piece)) return true;
                stage_ = Stage::spans;
                break;
            case Stage::spans:
                if (x_ < part_.end || begin_scanline()) {
                    if (next_span(piece)) return true;
                    break;
                }
                stage_ = gap_.end == INT32_MAX ? Stage::band : Stage::tiles;
                break;
        }
    }
}

// Goes on to the next band and finds what its scanlines cover.
bool ChordStepper::begin_band()
{
    if (next_y_ >= end_y_) return false;
    y_ = next_y_;
    const int32_t last = y_ | (kTileHeight - 1);
    next_y_ = last < end_y_ - 1 ? last + 1 : end_y_;
    scanlines_ = next_y_ - y_;
    for (int32_t scanline = 0; scanline < scanlines_; ++scanline) spans_[scanline] = outline_.scanline(y_ + scanline);
    scanline_ = 0;
    return true;
}

// Finds the columns of tiles; false where there are none: then the whole band is one gap.
bool ChordStepper::begin_tiles()
{
    constexpr int32_t kMargin = kTileHeight / 2;
    begin_gap(INT32_MIN, INT32_MAX);
    const int32_t top = y_ & -kTileHeight;
    const int32_t below = camera_.height_px() - 1;
    if (span_log2_ < kMinTileLog2 || top < 0 || top > below - kTileHeight || spans_[0].begin >= spans_[0].end)
        return false;
    const int32_t bottom = top + kTileHeight;
    const int32_t above_top = top > kMargin ? top - kMargin : 0;
    const int32_t below_bottom = bottom + kMargin < below ? bottom + kMargin : below;
    const Extent inside = outline_.columns(above_top, below_bottom, spans_[0], kMinTileLog2 - 1);
    constexpr int32_t kStep = 1 << kMinTileLog2;
    columns_ = {(inside.begin + kStep - 1) & -kStep, inside.end & -kStep};
    if (columns_.begin >= columns_.end) return false;
    const ScanlineRays first = hits_.rays_from(columns_.begin, top);
    tile_rays_[0] = first;
    tile_rays_[1] = hits_.moved(first, 0, kMargin);
    tile_rays_[2] = hits_.moved(first, 0, kTileHeight);
    hits_.evaluate(tile_rays_[0], 0, corners_[0][left_]);
    hits_.evaluate(tile_rays_[2], 0, corners_[1][left_]);
    tile_x_ = columns_.begin;
    drawn_x_ = INT32_MIN;
    tile_scanlines_.first = y_ - top;
    tile_scanlines_.count = scanlines_;
    return true;
}

// Looks for the next tile that can be drawn of which something is shown, or of the gap between it and the one before,
// which is left to spans.
bool ChordStepper::next_tile(Piece& piece)
{
    while (tile_x_ < columns_.end && drawn_x_ < shown_.end) {
        const int32_t x = tile_x_, gap_x = drawn_x_;
        const int width_log2 = prepare_tile();
        if (width_log2 == 0) continue;
        drawn_x_ = tile_x_;
        if (!is_shown(gap_x, tile_x_)) continue;
        piece = {Piece::Kind::cells, x, y_, 1 << width_log2, &tile_scanlines_};
        begin_gap(gap_x, x);
        return true;
    }
    return false;
}

// Sets up the tile at tile_x_, as wide as possible, and moves tile_x_ on; returns the logarithm of its width, or 0.
int ChordStepper::prepare_tile()
{
    const int32_t x = tile_x_;
    const int right = 1 - left_;
    const TileCorners tile = {&corners_[0][left_], &corners_[0][right], &corners_[1][left_], &corners_[1][right],
                              &centre_};
    int log2 = span_log2_;
    while ((x & ((1 << log2) - 1)) != 0 || x + (1 << log2) > columns_.end) --log2;
    bool fits = false;
    for (++log2; !fits && log2 > kMinTileLog2;) {
        --log2;
        const int32_t width = 1 << log2;
        const int32_t ahead = x + width - columns_.begin;
        hits_.evaluate(tile_rays_[0], ahead, corners_[0][right]);
        hits_.evaluate(tile_rays_[1], ahead - width / 2, centre_);
        hits_.evaluate(tile_rays_[2], ahead, corners_[1][right]);
        fits = front_tile_.prepare(tile, log2) && back_tile_.prepare(tile, log2) &&
               (all_baked() || is_baked(front_tile_.highest(width)));
    }
    left_ = right;
    tile_x_ = x + (1 << log2);
    return fits ? log2 : 0;
}

// Goes on to the next scanline of the tile right of the gap, and sets both lines anew, which a loop has moved.
bool ChordStepper::next_cut_scanline(Piece& piece)
{
    const int32_t x = gap_.end, width = tile_x_ - x, first = y_ & (kTileHeight - 1);
    tile_scanlines_.first = first;
    tile_scanlines_.count = scanlines_;
    if (cut_scanline_ == scanlines_) return false;
    tile_scanlines_.first = first + cut_scanline_;
    tile_scanlines_.count = 1;
    const int left = 1 - left_;
    const TileCorners tile = {&corners_[0][left], &corners_[0][left_], &corners_[1][left], &corners_[1][left_],
                              &centre_};
    const int width_log2 = __builtin_ctz(static_cast<uint32_t>(width));
    (void)front_tile_.prepare(tile, width_log2);
    (void)back_tile_.prepare(tile, width_log2);
    piece = {Piece::Kind::cells, x, y_ + cut_scanline_, width, &tile_scanlines_};
    ++cut_scanline_;
    return true;
}

void ChordStepper::begin_gap(int32_t begin, int32_t end)
{
    gap_ = {begin, end};
    scanline_ = begin < end ? 0 : scanlines_;
    part_ = {0, 0};
    x_ = 0;
    at_ = &corners_[0][1 - left_];
    end_ = &corners_[1][1 - left_];
}

// Goes on to the next scanline of the gap that covers something.
bool ChordStepper::begin_scanline()
{
    for (; scanline_ < scanlines_; ++scanline_) {
        span_ = spans_[scanline_];
        part_ = common(gap_, span_);
        if (part_.begin < part_.end && is_shown(part_.begin, part_.end)) break;
    }
    if (scanline_ == scanlines_) return false;
    LUMI_TALLY(Work::gap, 1);
    span_y_ = y_ + scanline_;
    ++scanline_;
    x_ = part_.begin;
    rays_ = hits_.rays_from(x_, span_y_);
    hits_.evaluate(rays_, 0, *at_);
    front_walker_.begin(*at_);
    back_walker_.begin(*at_);
    return true;
}

// Goes on by a span or a pixel; false where the stripe shows nothing of it.
bool ChordStepper::next_span(Piece& piece)
{
    if (x_ >= shown_.end) {
        x_ = part_.end;
        return false;
    }
    int32_t length = prepare_span();
    if (length == 0) {
        take_pixel();
        length = 1;
    }
    const LatticeLine& origins = front_track_.line;
    const bool is_whole =
        !origins.over_pole && !back_track_.line.over_pole && (all_baked() || is_baked(origins.cells.highest(length)));
    piece = {is_whole ? Piece::Kind::cells : Piece::Kind::checked, x_, span_y_, length, nullptr};
    x_ += length;
    return x_ > shown_.begin;
}

// Sets up the longest span that both lattices allow and returns how many pixels it has; 0 where there is none.
int32_t ChordStepper::prepare_span()
{
    const int32_t from_left = x_ - span_.begin;
    const int32_t from_right = span_.end - 1 - x_;
    int32_t length = from_right > 0 ? lengths_.length(from_left, from_right, part_.end - x_) : 0;
    while (length > 0) {
        hits_.evaluate(rays_, x_ - part_.begin + length, *end_);
        int32_t fits = front_walker_.prepare(*at_, *end_, length);
        if (fits == length) fits = back_walker_.prepare(*at_, *end_, length);
        if (fits == length) break;
        length = fits;
    }
    if (length == 0) return 0;
    const int32_t share = SpanLengths::shift_q8(from_left, from_right - length, length);
    if (share != 0) {
        front_walker_.shift(share);
        back_walker_.shift(share);
    }
    front_walker_.commit();
    back_walker_.commit();
    HitPair* const drawn = at_;
    at_ = end_;
    end_ = drawn;
    // The scanline's last pixel is the last span's end.
    return length == from_right ? length + 1 : length;
}

// Sets up one pixel by itself: a scanline's last one, or the last one before a pole.
void ChordStepper::take_pixel()
{
    (void)front_walker_.prepare(*at_, *at_, 1);
    (void)back_walker_.prepare(*at_, *at_, 1);
    if (x_ + 1 >= part_.end) return;
    hits_.evaluate(rays_, x_ - part_.begin + 1, *at_);
    front_walker_.begin(*at_);
    back_walker_.begin(*at_);
}

}  // namespace lumi::detail
