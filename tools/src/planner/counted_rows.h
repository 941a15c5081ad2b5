// SPDX-License-Identifier: MIT
// Core's loops over the rows of triangles, which count what they do.
#pragma once

#include "lumi/surface/see_through.h"
#include "planner/surface_work.h"
#include "surface/rows/row_loops.h"
#include "surface/see_through/rows.h"

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
    using Drawn = detail::BlendedPacked;
    using Blended = detail::BlendedPacked;
};

// Counts a row's samples, and then draws them.
template <class Samples, const LoopItems& kItems, detail::Filter kFilter, bool kIsSeeThrough>
void count_samples(uint16_t* first, const uint16_t* end, typename Samples::Drawn::Colour* colours, uint32_t first_depth,
                   uint32_t first_place, detail::PackedColour first_colour, const detail::Rows& rows)
{
    uint32_t depth = first_depth, place = first_place, colour = first_colour;
    uint32_t shown = 0, alone = 0, different = 0, at_rim = 0, clamped = 0;
    for (const uint16_t* at = first; at != end; ++at) {
        if (depth >> 16 > *at) {
            ++shown;
            alone += *at < detail::kFarDepth;
            clamped += ((colour + detail::filtered<kFilter>(place, rows)) & detail::kGuardBits) != 0;
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
    add(kItems.sample, static_cast<double>(end - first));
    add(kItems.shown, shown);
    add(kItems.clamped, clamped);
    add(kItems.rim, at_rim);
    add(kItems.blended, different);
    if constexpr (kIsSeeThrough) {
        add(SurfaceItem::see_alone, alone);
        detail::blend_samples<typename Samples::Blended, kFilter>(first, end, colours, first_depth, first_place,
                                                                  first_colour, rows);
    } else {
        detail::draw_samples<typename Samples::Drawn, kFilter>(first, end, colours, first_depth, first_place,
                                                               first_colour, rows);
    }
}

template <class Samples, const LoopItems& kItems, detail::Filter kFilter, bool kIsSeeThrough>
void count_rows(detail::Rows& rows)
{
    add(kItems.loop);
    add(kItems.row, rows.count + rows.count_below);
    detail::draw_rows<typename Samples::Drawn, kFilter, count_samples<Samples, kItems, kFilter, kIsSeeThrough>>(rows);
}

}  // namespace lumi::planner
