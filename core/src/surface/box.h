// SPDX-License-Identifier: MIT
// The box around a triangle, and what of it lies in a target.
#pragma once

#include "surface/extremes.h"
#include "surface/fill.h"

namespace lumi::detail
{

// Samples of a target: rows by their number in the frame, columns from the target's first.
struct Box {
    int32_t first_row, end_row, first_column, end_column;
    int32_t wide_q6, high_q6, longer_q6;  // sides of the whole box, and the longer one
    bool is_cut;                          // beside the target's columns there may be more of the triangle
};

// Whether some of three corners lies above the target's end and some below its start. Packed numbers compare as their
// upper bits do.
LUMI_ALWAYS_INLINE bool reaches(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c,
                                const Target& target)
{
    const int32_t top = target.y << 14, end = (target.y + target.rows.height) << 14;
    return (a.y > top || b.y > top || c.y > top) && (a.y < end || b.y < end || c.y < end);
}

// False if there is no sample.
LUMI_ALWAYS_INLINE bool set_box(Box& box, const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c,
                                const Target& target)
{
    // Packed numbers compare as their upper bits do.
    const int32_t top_q6 = least_of(a.y, b.y, c.y) >> 8, bottom_q6 = most_of(a.y, b.y, c.y) >> 8;
    const int32_t first_row = line_from(top_q6), end_row = line_from(bottom_q6);
    const int32_t below = target.y + target.rows.height;
    box.first_row = first_row > target.y ? first_row : target.y;
    box.end_row = end_row < below ? end_row : below;
    if (box.first_row >= box.end_row) return false;
    const int32_t left_q6 = least_of(a.x, b.x, c.x) >> 8, right_q6 = most_of(a.x, b.x, c.x) >> 8;
    // By no more than 1/64 sample roundings take a crossing beyond the corners.
    const int32_t first_column = line_from(left_q6 - 1) - target.x, end_column = line_from(right_q6 + 1) - target.x;
    const int32_t width = target.rows.width;
    box.wide_q6 = right_q6 - left_q6;
    box.high_q6 = bottom_q6 - top_q6;
    box.longer_q6 = box.wide_q6 > box.high_q6 ? box.wide_q6 : box.high_q6;

    box.is_cut = first_column < 0 || end_column > width;
    box.first_column = first_column > 0 ? first_column : 0;
    box.end_column = end_column < width ? end_column : width;
    return box.first_column < box.end_column;
}

// A depth that no sample of the triangle exceeds: larger ones are nearer. Planes (planes.h) round their steps to 2^-16
// of the corners' differences; over 2 · 96 samples of a triangle that sums up to less than 1/85 of them. An edge's
// crossing adds less than 1/700.
LUMI_ALWAYS_INLINE int32_t nearest_depth(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c)
{
    const int32_t da = static_cast<int32_t>(depth_of(a)), db = static_cast<int32_t>(depth_of(b)),
                  dc = static_cast<int32_t>(depth_of(c));
    const int32_t nearest = most_of(da, db, dc);
    return nearest + ((nearest - least_of(da, db, dc)) >> 6) + 2;
}

// Whether all samples of the box are nearer than any of the triangle can be.
LUMI_ALWAYS_INLINE bool is_hidden(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c,
                                  const Box& box, const Target& target)
{
    const int32_t most = nearest_depth(a, b, c);
    const uint8_t* row = target.rows.row(box.first_row - target.y);
    for (int32_t y = box.first_row; y < box.end_row; ++y, row += target.rows.row_bytes) {
        const uint16_t* at = reinterpret_cast<const uint16_t*>(row) + box.first_column;
        const uint16_t* const end = reinterpret_cast<const uint16_t*>(row) + box.end_column;
        do {
            if (*at < most) return false;
        } while (++at != end);
    }
    return true;
}

}  // namespace lumi::detail
