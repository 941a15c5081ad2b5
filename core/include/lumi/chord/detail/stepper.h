// SPDX-License-Identifier: MIT
// Cuts a stripe into pieces that are drawn by stepping: tiles where the sphere's inside allows them, spans in what is
// left. Knows nothing of texels, pixels and reconstructions: a loop draws each piece (chord/render_spans.h).
//
// Scanlines are taken in bands as high as a tile, on a grid that the image fixes. A band's scanlines come
// first, to fill what lies beside the sphere; then its tiles from left to right, each followed by the spans of
// the gap left of it. Pieces are those of the whole image, whatever columns the stripe has: where a scanline
// begins left of the stripe, hits are evaluated from its first pixel on.
#pragma once

#include "lumi/chord/detail/stepping/outline.h"
#include "lumi/chord/detail/stepping/walker.h"
#include "lumi/chord/detail/tile.h"
#include "lumi/chord/field.h"
#include "lumi/stripe.h"

namespace lumi::detail
{

// How a tile's lines change from scanline to scanline, and which of its scanlines the stripe holds.
struct TileScanlines {
    int32_t first, count;
    uint32_t stride_bytes;
    const LineChange& origins;
    const LineChange& directions;
};

struct Piece {
    enum class Kind : uint8_t {
        scanline,  // a scanline of the stripe begins: these pixels of the image are covered
        cells,     // a span or a tile, both lattices through cells that the field has
        checked,   // a span that needs care: over a pole, or with origins that are not baked
    };
    Kind kind;
    // In the image. A piece that the stripe's sides cut begins or ends beside the stripe (piece.h), and is one
    // scanline high.
    int32_t x, y;
    int32_t width;
    const TileScanlines* tile;  // null unless it is a tile
};

class ChordStepper
{
public:
    // Spans and tiles have at most 2^span_log2 pixels, 1 .. kMaxSpanLog2.
    ChordStepper(const Field& field, const Camera& camera, const Stripe& stripe, int span_log2);
    ChordStepper(const ChordStepper&) = delete;
    ChordStepper& operator=(const ChordStepper&) = delete;

    // Sets the next piece that lies in the stripe, or a part of which does, and both lines to where it lies; false
    // after the last one.
    bool next(Piece& piece);
    LatticeLine& origins() { return front_track_.line; }
    LatticeLine& directions() { return back_track_.line; }

private:
    enum class Stage : uint8_t { band, scanlines, tiles, cut_tile, spans };

    bool begin_band();
    bool begin_tiles();
    bool next_tile(Piece& piece);
    int prepare_tile();
    bool next_cut_scanline(Piece& piece);
    void begin_gap(int32_t begin, int32_t end);
    bool begin_scanline();
    bool next_span(Piece& piece);
    bool is_shown(int32_t begin, int32_t end) const { return begin < shown_.end && end > shown_.begin; }
    int32_t prepare_span();
    void take_pixel();
    bool all_baked() const { return field_.used_origins == field_.origins.size(); }
    bool is_baked(int32_t highest_origin) const { return highest_origin < static_cast<int32_t>(field_.used_origins); }

    static constexpr int kMinTileLog2 = 3;

    const Field& field_;
    const Camera& camera_;
    int span_log2_;
    const Extent shown_;  // the stripe's columns
    OutlineTracker outline_;
    HitEvaluator hits_;
    LatticeZones origins_, directions_;
    LatticeTrack front_track_, back_track_;
    TileWalker front_tile_, back_tile_;
    LineWalker front_walker_, back_walker_;
    SpanLengths lengths_;

    Stage stage_ = Stage::band;
    int32_t next_y_, end_y_;
    int32_t y_ = 0, scanlines_ = 0;  // the band: its first scanline, and how many it has
    Extent spans_[kTileHeight];      // what its scanlines cover
    int32_t scanline_ = 0;           // the next one to look at

    // Tiles: their columns, the next one's, the end of the last one; rays of their first scanline, their middle and the
    // scanline below; hits of their left and right corners, by turns, and of their middles.
    Extent columns_{0, 0};
    int32_t tile_x_ = 0, drawn_x_ = 0;
    int left_ = 0;
    int32_t cut_scanline_ = 0;  // the next one of a tile that the stripe's sides cut
    ScanlineRays tile_rays_[3];
    HitPair corners_[2][2];
    HitPair centre_;
    TileScanlines tile_scanlines_;

    // Spans: the gap's columns, what the scanline covers of the image and of the gap; hits of the next pixel to draw
    // and of the one where its span ends, in the place of corners that no tile needs meanwhile.
    Extent gap_{0, 0}, span_{0, 0}, part_{0, 0};
    int32_t x_ = 0, span_y_ = 0;
    ScanlineRays rays_;
    HitPair* at_ = nullptr;
    HitPair* end_ = nullptr;
};

}  // namespace lumi::detail
