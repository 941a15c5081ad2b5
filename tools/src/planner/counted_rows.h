// SPDX-License-Identifier: MIT
// Core's loops over the rows of triangles, which count what they do.
#pragma once

#include "lumi/surface/see_through.h"
#include "planner/surface_work.h"
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

}  // namespace lumi::planner
