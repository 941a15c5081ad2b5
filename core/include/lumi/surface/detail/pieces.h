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

#include "lumi/surface/detail/rows.h"
#include "lumi/surface/frame.h"

namespace lumi::detail
{

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

// The part of a triangle that lies in a target.
struct TrianglePiece {
    explicit TrianglePiece(const Target& target)
    {
        rows.row_bytes = target.row_bytes;
        rows.colours_at = target.colours_at;
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

struct Cut {
    Share corner[3];
};

// A triangle that is not drawn as a whole, and what is left of it; see split.h.
struct CutTriangle {
    static constexpr int kWholeLog2 = 16;
    static constexpr int kMost = 3 * kWholeLog2;

    uint32_t vertex[3];
    int32_t u_q8[3], v_q8[3];
    Texture texture;
    ViewPoint view[3];
    Cut pending[kMost];
    int32_t count = 0;
    SurfaceVertex corner[3];  // of the piece that is drawn
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

protected:
    bool next_cut();

    const SurfaceFrame& frame_;
    const Target& target_;
    ListWalk walk_;
    uint32_t other_;  // the next triangle of the other list, or kEmptyBand
    CutTriangle cut_;
};

// Does that where parts may move.
class MovingPieces : public TrianglePieces
{
public:
    using TrianglePieces::TrianglePieces;

    LUMI_HOT bool next();

private:
    bool next_cut();
};

// The pieces of a firmware whose parts may move, or of one that links nothing for that.
template <bool kMove, class Resting, class Moving>
struct PiecesFor {
    using Type = Resting;
};
template <class Resting, class Moving>
struct PiecesFor<true, Resting, Moving> {
    using Type = Moving;
};

// Cuts rows to what lies in the target, one after the other:
//
//     do {
//         cut.begin();
//         loop(rows);
//     } while (cut.end());
class CutRows
{
public:
    CutRows(Rows& rows, int32_t width)
        : rows_(rows), end_q16_(width * 65536), count_(rows.count), below_(rows.count_below)
    {
        rows.count_below = 0;
    }

    LUMI_ALWAYS_INLINE void begin()
    {
        left_q16_ = rows_.edge_q16[0];
        right_q16_ = rows_.edge_q16[1];
        if (left_q16_ < 0) rows_.edge_q16[0] = 0;
        if (right_q16_ > end_q16_) rows_.edge_q16[1] = end_q16_;
        rows_.count = 1;
    }

    // Returns false after the last row.
    LUMI_ALWAYS_INLINE bool end()
    {
        rows_.edge_q16[0] = left_q16_ + rows_.edge_step_q16[0];
        rows_.edge_q16[1] = right_q16_ + rows_.edge_step_q16[1];
        if (--count_ > 0) return true;
        if (below_ == 0) return false;
        count_ = below_;
        below_ = 0;
        rows_.bend();
        return true;
    }

private:
    Rows& rows_;
    const int32_t end_q16_;
    int32_t count_, below_;
    int32_t left_q16_, right_q16_;  // of the row, before it was cut
};

// Compared as parameters of templates: sanitizers compare addresses of functions at run time.
template <DrawRows, DrawRows>
inline constexpr bool kIsOneLoop = false;
template <DrawRows kDraw>
inline constexpr bool kIsOneLoop<kDraw, kDraw> = true;

template <DrawRows kDrawRows>
struct Loop {
    static constexpr DrawRows kDraw = kDrawRows;
};

// Draws every triangle of a frame that reaches a target; textures whose texels are larger than samples take the second
// loop. Pieces: TrianglePieces, over samples whose depths are kEmptyDepth, or SeeThroughPieces after these.
template <class Pieces, DrawRows kPlain, DrawRows kMagnified>
__attribute__((noinline)) void draw_triangles(const SurfaceFrame& frame, const Target& target)
{
    Pieces pieces(frame, target);
    TrianglePiece& piece = pieces.piece;
    const auto draw = [&](auto loop) __attribute__((always_inline))
    {
        if (!piece.is_cut) return decltype(loop)::kDraw(piece.rows);
        CutRows cut(piece.rows, target.width);
        do {
            cut.begin();
            decltype(loop)::kDraw(piece.rows);
        } while (cut.end());
    };
    while (pieces.next())
        if (!kIsOneLoop<kPlain, kMagnified> && piece.is_magnified)
            draw(Loop<kMagnified>{});
        else
            draw(Loop<kPlain>{});
}

}  // namespace lumi::detail
