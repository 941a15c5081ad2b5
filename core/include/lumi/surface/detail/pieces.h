// SPDX-License-Identifier: MIT
// The triangles of a frame that reach a target, one after the other, as pieces. The loops that draw them are the
// caller's, so that a firmware links those that it names.
//
//     TrianglePieces pieces(frame, target);
//     while (pieces.next()) loop(pieces.piece.rows);
//
// A sample belongs to a triangle if it lies right of the left edge or on it, left of the right edge, and between the
// rows of its ends. All of this is decided exactly on the vertices' grid: triangles that share an edge share neither a
// sample nor leave one out.
#pragma once

#include "lumi/surface/detail/row_loops.h"
#include "lumi/surface/frame.h"

namespace lumi::detail
{

// A rectangle of samples in memory, and how to draw into it.
struct Target {
    SampleRows rows;
    int32_t x, y;  // of its first sample, on the frame's grid
    const PackedColour* palette;
    bool has_two_taps;  // a texel is the sum of two, a quarter texel away on either side; the palette has halves
    // Textures that change by no more than so much of a texel a sample are read bilinearly; negative: none.
    int32_t magnified_q10;
};

// A rectangle of texels, see surface/format.h.
struct Texture {
    const uint8_t* texels;
    uint32_t columns, rows;
};

struct Corner {
    const SurfaceVertex* at;
    int32_t u_q8, v_q8;  // texels
};

// A triangle over which the rounding of steps of colour would add up. It is drawn in parts of a few rows, or of a few
// samples of a row, and each part begins with the right colour.
struct WideTriangle {
    int32_t right[3], down[3];  // what steps lose: green, red and blue, levels times 4, Q16
    int32_t column, row;        // where nothing is lost, from the target's first column and the piece's first row
    int32_t middle_step_q16;    // how far the middles of rows move to the right from one to the next
    int32_t frame_row;          // of the piece's first row
    PackedColour colour;        // Rows::colour of the piece's first row
    bool is_lost_in_rows;       // so parts are runs of a row

    int32_t at, part_rows;       // the part's first row, from the piece's, and its rows
    int32_t count, count_below;  // rows from there on, as in Rows
    int32_t run, end;            // columns of the row that are left
    int32_t edge_q16[2];         // of the row
};

// What of a triangle lies in a target.
struct TrianglePiece {
    explicit TrianglePiece(const Target& target)
    {
        rows.row_bytes = target.rows.row_bytes;
        rows.colours_at = target.rows.colours_at;
        rows.palette = target.palette;
        rows.has_two_taps = target.has_two_taps;
    }

    Rows rows;
    bool is_magnified;
    bool is_cut;  // rows may reach beyond the target's sides
    bool is_wide = false;
    WideTriangle wide;  // if it is
};

// A place before the division by its depth, formats of SurfaceProjection.
struct ViewPoint {
    int32_t x, y, z;
};

// A point of a triangle: shares of the corners b and c in 1/65536, a has the rest.
struct Share {
    int32_t b, c;
};

struct Part {
    Share corner[3];
};

// A triangle that is not drawn as a whole, and what is left of it; see split.h.
struct Parts {
    static constexpr int kWholeLog2 = 16;
    static constexpr int kMost = 3 * kWholeLog2;

    uint32_t vertex[3];
    int32_t u_q8[3], v_q8[3];
    Texture texture;
    ViewPoint view[3];
    Part pending[kMost];
    int32_t count = 0;
    SurfaceVertex corner[3];  // of the part that is drawn
};

// Goes through the lists of the bands that may reach a target's rows, nearest first.
struct ListWalk {
    int32_t begin, first, last;  // bands
    int32_t band;
    uint32_t nearness, triangle;  // the next one, or kEmptyBand
};

class TrianglePieces
{
public:
    TrianglePieces(const SurfaceFrame& frame, const Target& target);

    // Makes `piece` the next one; false after the last.
    LUMI_HOT bool next();

    TrianglePiece piece;

private:
    bool next_part();

    const SurfaceFrame& frame_;
    const Target& target_;
    ListWalk walk_;
    uint32_t other_;  // the next triangle of the other list, or kEmptyBand
    Parts parts_;
};

// Draws rows, each cut to what lies in the target.
template <DrawRows kDraw>
void draw_cut(Rows& rows, int32_t width)
{
    const int32_t end = width * 65536;
    int32_t count = rows.count, below = rows.count_below;
    rows.count_below = 0;
    while (true) {
        for (; count > 0; --count) {
            const int32_t left = rows.edge_q16[0], right = rows.edge_q16[1];
            if (left < 0) rows.edge_q16[0] = 0;
            if (right > end) rows.edge_q16[1] = end;
            rows.count = 1;
            kDraw(rows);
            rows.edge_q16[0] = left + rows.edge_step_q16[0];
            rows.edge_q16[1] = right + rows.edge_step_q16[1];
        }
        if (below == 0) return;
        count = below;
        below = 0;
        rows.edge_q16[rows.bent_edge] = rows.below.x_q16;
        rows.edge_step_q16[rows.bent_edge] = rows.below.step_q16;
    }
}

template <DrawRows kDraw>
LUMI_ALWAYS_INLINE void draw_piece(TrianglePiece& piece, int32_t width)
{
    if (piece.is_cut)
        draw_cut<kDraw>(piece.rows, width);
    else
        kDraw(piece.rows);
}

// Compared as parameters of templates: sanitizers compare addresses of functions at run time.
template <DrawRows, DrawRows>
inline constexpr bool kIsOneLoop = false;
template <DrawRows kDraw>
inline constexpr bool kIsOneLoop<kDraw, kDraw> = true;

// All pieces; textures whose texels are larger than samples take the second loop.
template <DrawRows kPlain, DrawRows kMagnified, class Pieces>
LUMI_ALWAYS_INLINE void draw_pieces(Pieces& pieces, const Target& target)
{
    while (pieces.next())
        if (!kIsOneLoop<kPlain, kMagnified> && pieces.piece.is_magnified)
            draw_piece<kMagnified>(pieces.piece, target.rows.width);
        else
            draw_piece<kPlain>(pieces.piece, target.rows.width);
}

// Draws every triangle that reaches a target, over samples whose depths are kEmptyDepth.
template <DrawRows kPlain, DrawRows kMagnified = kPlain>
__attribute__((noinline)) void draw_triangles(const SurfaceFrame& frame, const Target& target)
{
    TrianglePieces pieces(frame, target);
    draw_pieces<kPlain, kMagnified>(pieces, target);
}

}  // namespace lumi::detail
