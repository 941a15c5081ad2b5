// SPDX-License-Identifier: MIT
#include "surface/fill.h"

namespace lumi::detail
{
namespace
{

// A part has so many rows, which begin with a multiple of that in the frame, or so many samples of a row, which begin
// at its left end: targets that show the same triangle cut it in the same parts.
constexpr int32_t kPartRows = 8, kPartSamples = 32;

// The colour of a part, whose middle lies so far from where nothing is lost.
PackedColour colour_of_part(const WideTriangle& wide, const Rows& rows, int32_t right, int32_t down)
{
    // PackedColour has two bits of fraction for green and red, and one for blue.
    const auto lost = [&](int k, int drop) {
        const int32_t sum = wide.right[k] * right + wide.down[k] * down;
        return static_cast<uint32_t>((sum + (1 << (15 + drop))) >> (16 + drop));
    };
    return wide.colour + static_cast<uint32_t>(wide.at) * rows.colour_down + (lost(0, 0) << 21) + (lost(1, 0) << 10) +
           lost(2, 1);
}

// A run of samples of the row at `wide.at`.
void set_run(WideTriangle& wide, Rows& rows)
{
    const int32_t begin = wide.run, left = wide.end - begin;
    wide.run = left > kPartSamples ? begin + kPartSamples : wide.end;
    rows.colour = colour_of_part(wide, rows, ((begin + wide.run) >> 1) - wide.column, wide.at - wide.row);
    rows.edge_q16[0] = begin * 65536;
    rows.edge_q16[1] = wide.run * 65536;
    wide.part_rows = rows.count = 1;
}

void set_rows(WideTriangle& wide, Rows& rows)
{
    const int32_t over = (wide.frame_row + wide.at) & (kPartRows - 1), left = kPartRows - over;
    const int32_t down = wide.at - over + kPartRows / 2 - wide.row;
    rows.colour = colour_of_part(wide, rows, (wide.middle_step_q16 * down) >> 16, down);
    wide.part_rows = rows.count = left < wide.count ? left : wide.count;
}

// Goes to the next row, or to the next rows where parts have several; false: there is none.
bool next_rows(WideTriangle& wide, Rows& rows)
{
    wide.at += wide.part_rows;
    wide.count -= wide.part_rows;
    if (wide.count != 0) return true;
    wide.count = wide.count_below;
    wide.count_below = 0;
    if (wide.count == 0) return false;
    rows.edge_q16[rows.bent_edge] = rows.below.x_q16;
    rows.edge_step_q16[rows.bent_edge] = rows.below.step_q16;
    return true;
}

void set_first_part(WideTriangle& wide, Rows& rows)
{
    if (!wide.is_lost_in_rows) return set_rows(wide, rows);
    for (int k = 0; k < 2; ++k) wide.edge_q16[k] = rows.edge_q16[k];
    wide.run = rows.edge_q16[0] >> 16;
    wide.end = rows.edge_q16[1] >> 16;
    set_run(wide, rows);
}

// The rows are those after the row of the run.
void go_back_to_row(Rows& rows)
{
    rows.depth -= rows.depth_down;
    rows.place -= rows.place_down;
    rows.row -= rows.row_bytes;
}

}  // namespace

void begin_wide(TrianglePiece& piece, int32_t long_step_q16, int32_t frame_row)
{
    WideTriangle& wide = piece.wide;
    Rows& rows = piece.rows;
    piece.is_wide = true;
    wide.middle_step_q16 = long_step_q16;
    wide.frame_row = frame_row;
    wide.colour = rows.colour;
    wide.at = 0;
    wide.count = rows.count;
    wide.count_below = rows.count_below;
    rows.count_below = 0;
    set_first_part(wide, rows);
}

LUMI_HOT bool next_part_of_wide(TrianglePiece& piece)
{
    LUMI_TALLY(Work::wide, 1);
    WideTriangle& wide = piece.wide;
    Rows& rows = piece.rows;
    if (wide.is_lost_in_rows) {
        if (wide.run < wide.end) {
            go_back_to_row(rows);
            set_run(wide, rows);
            return true;
        }
        for (int k = 0; k < 2; ++k) rows.edge_q16[k] = wide.edge_q16[k] + rows.edge_step_q16[k];
    }
    piece.is_wide = next_rows(wide, rows);
    if (piece.is_wide) set_first_part(wide, rows);
    return piece.is_wide;
}

}  // namespace lumi::detail
