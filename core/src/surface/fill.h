// SPDX-License-Identifier: MIT
// Begins triangles in a target: which samples they may cover, and depth, texture, colour and edges of their rows.
#pragma once

#include "surface/projection.h"

namespace lumi::detail
{

// Returns a vertex's share of the colour: 3 signed fields of 10 bits, levels times 4.
LUMI_ALWAYS_INLINE int32_t red_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour) >> 22;
}
LUMI_ALWAYS_INLINE int32_t green_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour << 10) >> 22;
}
LUMI_ALWAYS_INLINE int32_t blue_q2(uint32_t colour)
{
    return static_cast<int32_t>(colour << 20) >> 22;
}

inline constexpr int32_t kInsetQ8 = 256 >> format::kPatchInsetShift;

LUMI_ALWAYS_INLINE Texture texture_of(const SurfacePatch& patch, const SurfaceField& field)
{
    return {field.texels + patch.texels, patch.columns, patch.rows};
}

// Places in the texture of a patch's first triangle (a, b, c) or second one (d, c, b): from its first corner the one
// goes right and down, the other left and up.
struct Places {
    int32_t u_q8, v_q8, across_q8, down_q8;
};

LUMI_ALWAYS_INLINE Places places_of(const SurfacePatch& patch, bool is_first)
{
    const int32_t right = static_cast<int32_t>(patch.columns << 8) - kInsetQ8;
    const int32_t bottom = static_cast<int32_t>(patch.rows << 8) - kInsetQ8;
    if (is_first) return {kInsetQ8, kInsetQ8, right, bottom};
    return {right, bottom, kInsetQ8, kInsetQ8};
}

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
    LUMI_TALLY(Work::boxed, 1);
    const int32_t most = nearest_depth(s);
    const uint8_t* row = target.row(size.first_row - target.y);
    for (int32_t y = size.first_row; y < size.end_row; ++y, row += target.row_bytes) {
        const uint16_t* at = reinterpret_cast<const uint16_t*>(row) + columns.begin;
        const uint16_t* const end = reinterpret_cast<const uint16_t*>(row) + columns.end;
        do {
            LUMI_TALLY(Work::looked_at, 1);
            if (*at < most) return false;
        } while (++at != end);
    }
    return true;
}

// Begins a triangle at most kSmallQ6 wide and high whose corners are there and lie counter-clockwise on the screen;
// false: it lies another way. `size` is its size, and it has rows in the target.
LUMI_HOT bool begin_triangle(TrianglePiece& piece, const Corner (&corner)[3], const TriangleSize& size,
                             const Texture& texture, const Target& target);

// Colour may lose so many levels from one side of a triangle to the other: nothing in the middle, and half of it at
// either end. In triangles of less than kWideQ6 samples it never loses more, for blue, which loses most, loses at most
// a quarter level a sample.
inline constexpr int32_t kMostLostQ24 = 6 << 24, kWideQ6 = kMostLostQ24 >> 16;

// Whether rounded steps of colour may lose so much that it takes a look.
LUMI_ALWAYS_INLINE bool may_lose_colour(int32_t longer_q6, const SurfaceVertex& a, const SurfaceVertex& b,
                                        const SurfaceVertex& c)
{
    return longer_q6 >= kWideQ6 && (a.colour | b.colour | c.colour) != 0;
}

// Begins a wide triangle (WideTriangle) with its first part. `wide` holds what is lost; `long_step_q16` is the step of
// the edge from the upper end to the lower one, and `frame_row` that of the piece's first row.
void begin_wide(TrianglePiece& piece, int32_t long_step_q16, int32_t frame_row);

// Makes the piece the next part, after rows have been drawn; false after the last, and then it is not wide any more.
LUMI_HOT bool next_part_of_wide(TrianglePiece& piece);

void begin_cut(CutTriangle& cut, const SurfaceFrame& frame, uint32_t triangle);
// Sets `corner`, and the vertices that it names, to the next piece that can be drawn as a whole; false after the last.
bool next_cut(CutTriangle& cut, const SurfaceFrame& frame, const Target& target, Corner (&corner)[3]);

// Begins a triangle that is drawn as a whole; false if none of it shows.
LUMI_ALWAYS_INLINE bool begin_whole(TrianglePiece& piece, const SurfaceFrame& frame, uint32_t triangle,
                                    const Target& target)
{
    LUMI_TALLY(Work::offered, 1);
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    const bool is_first = (triangle & 1) == 0;
    const SurfaceVertex *a = v + patch.corner[0], *b = v + patch.corner[1], *c = v + patch.corner[2];
    if (!is_first) {
        const SurfaceVertex* const first = b;
        a = v + patch.corner[3];
        b = c;
        c = first;
    }
    const Seen s = {a, b, c};
    TriangleSize size;
    Extent columns;
    if (!set_size(size, columns, s, target) || is_hidden(s, size, columns, target)) return false;
    const Places p = places_of(patch, is_first);
    return begin_triangle(piece, {{a, p.u_q8, p.v_q8}, {b, p.across_q8, p.v_q8}, {c, p.u_q8, p.down_q8}}, size,
                          texture_of(patch, frame.field), target);
}

// Begins the next piece of a triangle that begin_cut() began; false after the last.
inline bool begin_piece(TrianglePiece& piece, const SurfaceFrame& frame, CutTriangle& cut, const Target& target)
{
    Corner corner[3];
    while (next_cut(cut, frame, target, corner)) {
        TriangleSize size;
        Extent columns;
        if (set_size(size, columns, {corner[0].at, corner[1].at, corner[2].at}, target) &&
            begin_triangle(piece, corner, size, cut.texture, target))
            return true;
    }
    return false;
}

}  // namespace lumi::detail
