// SPDX-License-Identifier: MIT
// Which samples of a target a triangle may cover.
#pragma once

#include "surface/fill.h"
#include "surface/seen.h"

namespace lumi::detail
{

// How much of a triangle's height lies in a target, and how large the whole triangle is.
struct TriangleSize {
    int32_t first_row, end_row;           // by their number in the frame
    int32_t wide_q6, high_q6, longer_q6;  // sides of the box around the triangle, and the longer one
    bool is_cut;                          // beside the target's columns there may be more of the triangle
};

// Whether some corner lies above the target's end and some below its start. Packed numbers compare as their upper bits
// do.
LUMI_ALWAYS_INLINE bool reaches(const Seen& s, const Target& target)
{
    const int32_t top = target.y << 14, end = (target.y + target.height) << 14;
    return (s.a->y > top || s.b->y > top || s.c->y > top) && (s.a->y < end || s.b->y < end || s.c->y < end);
}

// Sets `columns`, from the target's first, too; false if there is no sample.
LUMI_ALWAYS_INLINE bool set_size(TriangleSize& size, Extent& columns, const Seen& s, const Target& target)
{
    // Packed numbers compare as their upper bits do.
    const int32_t top_q6 = s.upper() >> 8, bottom_q6 = s.lower() >> 8;
    const int32_t first_row = line_from(top_q6), end_row = line_from(bottom_q6);
    const int32_t below = target.y + target.height;
    size.first_row = first_row > target.y ? first_row : target.y;
    size.end_row = end_row < below ? end_row : below;
    if (size.first_row >= size.end_row) return false;
    const int32_t left_q6 = s.left() >> 8, right_q6 = s.right() >> 8;
    // By no more than 1/64 sample roundings take a crossing beyond the corners.
    const int32_t first_column = line_from(left_q6 - 1) - target.x, end_column = line_from(right_q6 + 1) - target.x;
    const int32_t width = target.width;
    size.wide_q6 = right_q6 - left_q6;
    size.high_q6 = bottom_q6 - top_q6;
    size.longer_q6 = size.wide_q6 > size.high_q6 ? size.wide_q6 : size.high_q6;
    size.is_cut = first_column < 0 || end_column > width;
    columns.begin = first_column > 0 ? first_column : 0;
    columns.end = end_column < width ? end_column : width;
    return columns.begin < columns.end;
}

// A depth that no sample of the triangle exceeds: larger ones are nearer. Planes (planes.h) round their steps to 2^-16
// of the corners' differences; over 2 · 96 samples of a triangle that sums up to less than 1/85 of them. An edge's
// crossing adds less than 1/700.
LUMI_ALWAYS_INLINE int32_t nearest_depth(const Seen& s)
{
    const int32_t da = static_cast<int32_t>(depth_of(*s.a)), db = static_cast<int32_t>(depth_of(*s.b)),
                  dc = static_cast<int32_t>(depth_of(*s.c));
    const int32_t nearest = most_of(da, db, dc);
    return nearest + ((nearest - least_of(da, db, dc)) >> 6) + 2;
}

// Whether all samples there are nearer than any of the triangle can be.
LUMI_ALWAYS_INLINE bool is_hidden(const Seen& s, const TriangleSize& size, const Extent& columns, const Target& target)
{
    const int32_t most = nearest_depth(s);
    const uint8_t* row = target.row(size.first_row - target.y);
    for (int32_t y = size.first_row; y < size.end_row; ++y, row += target.row_bytes) {
        const uint16_t* at = reinterpret_cast<const uint16_t*>(row) + columns.begin;
        const uint16_t* const end = reinterpret_cast<const uint16_t*>(row) + columns.end;
        do {
            if (*at < most) return false;
        } while (++at != end);
    }
    return true;
}

}  // namespace lumi::detail
