// SPDX-License-Identifier: MIT
// Core's loops over the rows of triangles, which count what they do.
#pragma once

#include <cmath>

#include "lumi/surface/render.h"
#include "planner/surface_work.h"
#include "surface/fill.h"
#include "surface/lists.h"
#include "surface/order.h"
#include "surface/row_loops.h"

namespace lumi::planner
{

// Counts of the loops that take nothing but rows.
inline thread_local SurfaceWork* counted = nullptr;

inline void add(SurfaceItem item, double count = 1)
{
    (*counted)[item] += count;
}

// Items of a loop: opaque or see-through triangles, textures that are read bilinearly or not.
struct LoopItems {
    SurfaceItem loop, row, filled, sample, shown, clamped, rim, blended;
};
inline constexpr LoopItems kPlain = {SurfaceItem::loop,   SurfaceItem::row,    SurfaceItem::filled,
                                     SurfaceItem::sample, SurfaceItem::shown,  SurfaceItem::clamped,
                                     SurfaceItem::rim,    SurfaceItem::blended};
inline constexpr LoopItems kMagnified = {SurfaceItem::magnified_loop,
                                         SurfaceItem::magnified_row,
                                         SurfaceItem::magnified_filled,
                                         SurfaceItem::magnified_sample,
                                         SurfaceItem::magnified_shown,
                                         SurfaceItem::clamped,
                                         SurfaceItem::rim,
                                         SurfaceItem::blended};
inline constexpr LoopItems kSeePlain = {SurfaceItem::see_loop,   SurfaceItem::see_row,    SurfaceItem::see_filled,
                                        SurfaceItem::see_sample, SurfaceItem::see_shown,  SurfaceItem::see_clamped,
                                        SurfaceItem::see_rim,    SurfaceItem::see_blended};
inline constexpr LoopItems kSeeMagnified = {SurfaceItem::see_loop,
                                            SurfaceItem::see_row,
                                            SurfaceItem::see_filled,
                                            SurfaceItem::see_magnified_sample,
                                            SurfaceItem::see_magnified_shown,
                                            SurfaceItem::see_clamped,
                                            SurfaceItem::see_rim,
                                            SurfaceItem::see_blended};

// Says of a sample that is read bilinearly whether its texels differ, and whether they lie at their rectangle's rim.
struct FourTexelsKind {
    bool differ, at_rim;

    FourTexelsKind(uint32_t place, const detail::Rows& rows)
    {
        const detail::FourTexels t = detail::texels_around(place, rows);
        const uint8_t first = t.upper[t.left];
        differ = t.upper[t.right] != first || t.lower[t.left] != first || t.lower[t.right] != first;
        const uint32_t column = ((place & 0xFFFF) - 512) >> 10, row = ((place >> 16) - 512) >> 10;
        at_rim = column >= rows.columns - 1 || row >= rows.texel_rows - 1;
    }
};

// Samples as core keeps them, opaque ones and those behind see-through triangles.
struct Pixels {
    using Drawn = detail::Sample565<PixelRgb565>;
    using Blended = detail::Blended565<PixelRgb565, false>;
};
struct Packed {
    using Drawn = detail::PackedSample;
    using Blended = detail::BlendedPacked;
};

// Counts the samples of a row, as core's draw_rows goes through them.
template <const LoopItems& kItems, detail::Filter kFilter, bool kIsSeeThrough>
void count_samples(const detail::Rows& rows)
{
    const int32_t first = rows.edge_q16[0] >> 16, last = rows.edge_q16[1] >> 16;
    if (first >= last) return;
    const uint32_t column = static_cast<uint32_t>(first);
    const auto* const depths = reinterpret_cast<const uint16_t*>(rows.row);
    uint32_t depth = rows.depth + column * rows.depth_right, place = rows.place + column * rows.place_right;
    detail::PackedColour colour = rows.colour + column * rows.colour_right;
    uint32_t shown = 0, alone = 0, different = 0, at_rim = 0, clamped = 0;
    for (int32_t x = first; x < last; ++x) {
        if (depth >> 16 > depths[x]) {
            ++shown;
            alone += depths[x] < detail::kFarDepth;
            clamped += ((colour + detail::texel<kFilter>(place, rows)) & detail::kGuardBits) != 0;
            if (kFilter == detail::Filter::bilinear) {
                const FourTexelsKind kind(place, rows);
                different += kind.differ;
                at_rim += kind.at_rim;
            }
        }
        depth += rows.depth_right;
        place += rows.place_right;
        colour += rows.colour_right;
    }
    add(kItems.filled);
    add(kItems.sample, last - first);
    add(kItems.shown, shown);
    add(kItems.clamped, clamped);
    add(kItems.rim, at_rim);
    add(kItems.blended, different);
    if (kIsSeeThrough) add(SurfaceItem::see_alone, alone);
}

// Goes to the next row, as core's draw_rows does; false after the last.
inline bool next_row(detail::Rows& rows)
{
    for (int k = 0; k < 2; ++k) rows.edge_q16[k] += rows.edge_step_q16[k];
    rows.depth += rows.depth_down;
    rows.place += rows.place_down;
    rows.colour += rows.colour_down;
    rows.row += rows.row_bytes;
    if (--rows.count != 0) return true;
    if (rows.count_below == 0) return false;
    rows.count = rows.count_below;
    rows.count_below = 0;
    rows.bend();
    return true;
}

// Counts what rows have, and then draws them.
template <class Samples, const LoopItems& kItems, detail::Filter kFilter, bool kIsSeeThrough>
void count_rows(detail::Rows& rows)
{
    add(kItems.loop);
    add(kItems.row, rows.count + rows.count_below);
    detail::Rows counted_rows = rows;
    do count_samples<kItems, kFilter, kIsSeeThrough>(counted_rows);
    while (next_row(counted_rows));
    if constexpr (kIsSeeThrough)
        detail::draw_rows<typename Samples::Blended, kFilter>(rows);
    else
        detail::draw_rows<typename Samples::Drawn, kFilter>(rows);
}

// The pieces that core draws triangles in, counted while they are made.

// How many samples core looks at to know whether a triangle is hidden (src/surface/fill.h); 0: its box has none.
inline uint32_t looked_at(const detail::Seen& s, const detail::Target& target)
{
    detail::TriangleSize size;
    detail::Extent columns;
    if (!detail::set_size(size, columns, s, target)) return 0;
    const int32_t most = detail::nearest_depth(s);
    uint32_t count = 0;
    for (int32_t y = size.first_row; y < size.end_row; ++y)
        for (int32_t x = columns.begin; x < columns.end; ++x) {
            ++count;
            if (target.depths(y - target.y)[x] < most) return count;
        }
    return count;
}

// Whether core looks at what a triangle's colour loses (src/surface/fill.cpp).
inline bool is_looked_at_for_colour(const detail::Seen& s, const detail::Target& target)
{
    detail::TriangleSize size;
    detail::Extent columns;
    return detail::set_size(size, columns, s, target) && detail::may_lose_colour(size.longer_q6, *s.a, *s.b, *s.c);
}

// Begins a triangle as a whole; false if none of it shows.
inline bool begins(detail::TrianglePiece& piece, const SurfaceFrame& frame, uint32_t triangle,
                   const detail::Target& target, SurfaceItem boxed, SurfaceItem looked, SurfaceItem begun)
{
    if (const uint32_t count = looked_at(detail::seen(frame, triangle), target); count != 0) {
        add(boxed);
        add(looked, count);
    }
    if (!detail::begin_whole(piece, frame, triangle, target)) return false;
    add(begun);
    if (is_looked_at_for_colour(detail::seen(frame, triangle), target)) add(SurfaceItem::wide_looked_at);
    return true;
}

// The parts of a large triangle. Each halving halves its area, so the parts that are drawn tell how much was dropped,
// and nearly how many steps that took.
class CountedParts
{
public:
    CountedParts(const SurfaceFrame& frame, const detail::Target& target) : frame_(frame), target_(target) {}

    void begin(uint32_t triangle)
    {
        add(SurfaceItem::large);
        detail::begin_cut(cut_, frame_, triangle);
        left_ = 1;
        ready_ = 0;
    }

    // False after the last.
    bool next(detail::TrianglePiece& piece)
    {
        if (cut_.count == 0) return false;
        detail::Corner corner[3];
        while (detail::next_cut(cut_, frame_, target_, corner)) {
            ++ready_;
            left_ -= share_of(corner);
            detail::TriangleSize size;
            detail::Extent columns;
            if (detail::set_size(size, columns, {corner[0].at, corner[1].at, corner[2].at}, target_) &&
                detail::begin_triangle(piece, corner, size, cut_.texture, target_)) {
                add(SurfaceItem::parts);
                return true;
            }
        }
        add(SurfaceItem::halved, 2 * (ready_ + dropped()) - 1);
        return false;
    }

private:
    // Returns the triangle's area as a power of two.
    double share_of(const detail::Corner (&c)[3]) const
    {
        const auto area = [](double au, double av, double bu, double bv) { return std::fabs(au * bv - bu * av); };
        const double whole = area(cut_.u_q8[1] - cut_.u_q8[0], cut_.v_q8[1] - cut_.v_q8[0], cut_.u_q8[2] - cut_.u_q8[0],
                                  cut_.v_q8[2] - cut_.v_q8[0]);
        const double part =
            area(c[1].u_q8 - c[0].u_q8, c[1].v_q8 - c[0].v_q8, c[2].u_q8 - c[0].u_q8, c[2].v_q8 - c[0].v_q8);
        return part > 0 ? std::exp2(std::round(std::log2(part / whole))) : 0;
    }

    // Parts that lie beside the target, at least: a binary fraction has as many powers of two.
    int dropped() const
    {
        int count = 0;
        constexpr int kDeepest = 20;
        double rest = std::max(left_, 0.0);
        for (int k = 0; k <= kDeepest; ++k)
            if (const double power = std::exp2(-k); rest >= power) {
                rest -= power;
                ++count;
            }
        return count;
    }

    const SurfaceFrame& frame_;
    const detail::Target& target_;
    detail::CutTriangle cut_;
    double left_ = 0;
    int ready_ = 0;
};

// Whether a wide triangle has another part.
inline bool goes_on(detail::TrianglePiece& piece)
{
    if (piece.is_wide) add(SurfaceItem::wide);
    return piece.is_wide && detail::next_part_of_wide(piece);
}

// Draws as detail::TrianglePieces does, and counts.
class CountedPieces
{
public:
    CountedPieces(const SurfaceFrame& frame, const detail::Target& target)
        : piece(target),
          frame_(frame),
          target_(target),
          walk_(detail::walk_of(frame, target)),
          other_(frame.memory.bands[frame.other_list]),
          parts_(frame, target)
    {
    }

    bool next()
    {
        if (goes_on(piece)) return true;
        for (uint32_t triangle = 0; detail::next_listed(walk_, frame_, triangle);) {
            add(SurfaceItem::visited);
            if (begins(piece, frame_, triangle, target_, SurfaceItem::boxed, SurfaceItem::looked_at,
                       SurfaceItem::begun))
                return true;
        }
        return next_part();
    }

    detail::TrianglePiece piece;

private:
    bool next_part()
    {
        while (true) {
            if (parts_.next(piece)) return true;
            if (other_ == detail::kEmptyBand) return false;
            parts_.begin(other_);
            other_ = detail::after(other_, frame_.memory.links[other_]);
        }
    }

    const SurfaceFrame& frame_;
    const detail::Target& target_;
    detail::ListWalk walk_;
    uint32_t other_;
    CountedParts parts_;
};

// Draws as detail::SeeThroughPieces does.
class CountedSeeThrough
{
public:
    CountedSeeThrough(const SurfaceFrame& frame, const detail::Target& target)
        : piece(target), frame_(frame), target_(target), parts_(frame, target)
    {
        piece.rows.palette = detail::see_through_palette(frame);
    }

    bool next()
    {
        if (goes_on(piece)) return true;
        while (true) {
            if (parts_.next(piece)) return true;
            if (at_ == frame_.see_through_triangles) return false;
            const uint32_t entry = frame_.memory.features[at_++], triangle = detail::triangle_of(entry);
            add(SurfaceItem::see_visited);
            if ((entry & detail::kIsCut) != 0)
                parts_.begin(triangle);
            else if (begins(piece, frame_, triangle, target_, SurfaceItem::see_boxed, SurfaceItem::see_looked_at,
                            SurfaceItem::see_begun))
                return true;
        }
    }

    detail::TrianglePiece piece;

private:
    const SurfaceFrame& frame_;
    const detail::Target& target_;
    uint32_t at_ = 0;
    CountedParts parts_;
};

}  // namespace lumi::planner
