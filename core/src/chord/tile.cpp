// SPDX-License-Identifier: MIT
#include "lumi/detail/chord/tile.h"

#include "lumi/detail/register_hints.h"

namespace lumi
{
namespace
{

// A quantity over a tile: at its first pixel, and what it changes by from its left edge to the right one, from its top
// to its bottom, and along its bottom more than along its top.
struct Bilinear {
    int32_t begin, across, down, twist;
    int32_t rise;  // of the middle above the plane between the corners
};

LUMI_ALWAYS_INLINE Bilinear bilinear(int32_t top_left, int32_t top_right, int32_t bottom_left, int32_t bottom_right,
                                     int32_t centre)
{
    constexpr int32_t kTwoThirdsQ8 = 171;
    const int32_t rise = centre - ((top_left + top_right + bottom_left + bottom_right) >> 2);
    const int32_t across = top_right - top_left;
    // The middle of a tile lies off the plane between its corners by the most, two thirds of it in the mean.
    return {top_left + (((rise >> 3) * kTwoThirdsQ8) >> 5), across, bottom_left - top_left,
            bottom_right - bottom_left - across, rise};
}

// Whether the magnitude is at most `limit`, which is not negative.
LUMI_ALWAYS_INLINE bool within(int32_t v, int32_t limit)
{
    return static_cast<uint32_t>(v + limit) <= 2 * static_cast<uint32_t>(limit);
}

}  // namespace

bool TileWalker::prepare(const TileCorners& corners, int width_log2)
{
    if (prepare_cells(corners, width_log2)) return true;
    return prepare_cap(corners, width_log2);
}

bool TileWalker::prepare_cells(const TileCorners& corners, int width_log2)
{
    const SpanHit& top_left = corners.top_left->*track_.hit;
    const SpanHit& top_right = corners.top_right->*track_.hit;
    const SpanHit& bottom_left = corners.bottom_left->*track_.hit;
    const SpanHit& bottom_right = corners.bottom_right->*track_.hit;
    const SpanHit& centre = corners.centre->*track_.hit;
    SpanChart& chart = track_.chart;
    SpanSide& side = track_.side;
    if (!chart.holds(centre.z_q30)) {
        if (!within(centre.z_q30, chart.lattice().cap_z_q30)) return false;
        chart.choose(centre.z_q30, side);
    }
    const auto turn_q20 = [&](const SpanHit& hit) {
        return static_cast<int32_t>(hit.longitude_turns32 - top_left.longitude_turns32) >> 12;
    };
    const int32_t turns[] = {turn_q20(top_right), turn_q20(bottom_left), turn_q20(bottom_right)};
    if (!within(turns[0], kMaxTurnQ20) || !within(turns[1], kMaxTurnQ20) || !within(turns[2], kMaxTurnQ20))
        return false;
    const auto z_q25 = [](const SpanHit& hit) { return hit.z_q30 >> 5; };
    const int32_t z_of[] = {z_q25(top_left), z_q25(top_right), z_q25(bottom_left), z_q25(bottom_right)};
    const Bilinear z = bilinear(z_of[0], z_of[1], z_of[2], z_of[3], z_q25(centre));
    // Indices depend on heights alone: moving the tile by its middle's rise changes them by no more than that height.
    // Rounding does by less than five: at 65,536 points and steps of 233 and 377, 1.8 by floors of four heights in Q16,
    // 1.3 by floors of steps, 1.9 in PairRows; by less than two and a height of 6/65536 for all sizes.
    constexpr int32_t kRoundingQ25 = 6 << 9;
    const int32_t spare_q25 = magnitude(z.rise) + (chart.lattice().step_z_q30 >> 3) + kRoundingQ25;
    const int32_t lowest_q25 = (chart.lowest_z_q30() >> 5) + spare_q25;
    const int32_t highest_q25 = (chart.highest_z_q30() >> 5) - spare_q25;
    if (lowest_q25 > highest_q25) return false;
    for (const int32_t corner_q25 : z_of) {
        if (static_cast<uint32_t>(corner_q25 - lowest_q25) > static_cast<uint32_t>(highest_q25 - lowest_q25))
            return false;
    }
    constexpr int32_t kMostTwistQ25 = 2 << 25;  // no view comes near it; products with scales stay below 2^31
    if (!within(z.twist, kMostTwistQ25)) return false;

    const Bilinear longitude = bilinear(0, turns[0], turns[1], turns[2], turn_q20(centre));
    set(chart.at(static_cast<int32_t>(top_left.longitude_turns32 >> 12) + longitude.begin, z.begin >> 9),
        {chart.change(longitude.across, z.across >> 9), chart.change(longitude.down, z.down >> 9),
         chart.change(longitude.twist, z.twist >> 9)},
        width_log2);
    side.uniform = chart.is_uniform_at(top_left.z_q30) && chart.is_uniform_at(top_right.z_q30) &&
                   chart.is_uniform_at(bottom_left.z_q30) && chart.is_uniform_at(bottom_right.z_q30);
    side.z_q30 = centre.z_q30;
    side.cap = nullptr;
    return true;
}

// Where the polar pattern holds the whole tile.
bool TileWalker::prepare_cap(const TileCorners& corners, int width_log2)
{
    const SpanNode* const nodes[] = {corners.top_left, corners.top_right, corners.bottom_left, corners.bottom_right,
                                     corners.centre};
    const int32_t reach = track_.chart.lattice().reach_z_q30;
    const bool mirrored = (corners.centre->*track_.hit).z_q30 < 0;
    for (const SpanNode* node : nodes) {
        const int32_t z = (node->*track_.hit).z_q30;
        if ((mirrored ? -z : z) < reach) return false;
    }
    track_.enter_cap(mirrored);
    LatticePoint at[5];
    for (int k = 0; k < 5; ++k) at[k] = track_.in_plane(*nodes[k], mirrored);
    const Bilinear u = bilinear(at[0].u_q16, at[1].u_q16, at[2].u_q16, at[3].u_q16, at[4].u_q16);
    const Bilinear v = bilinear(at[0].v_q16, at[1].v_q16, at[2].v_q16, at[3].v_q16, at[4].v_q16);
    set({u.begin, v.begin}, {{u.across, v.across}, {u.down, v.down}, {u.twist, v.twist}}, width_log2);
    // All rows look for their first triangle from the one under the middle of the left edge: none depends on others.
    SpanCap& cap = track_.cap;
    cap.triangle = 0;
    cap.x_q12 = (track_.side.u_q16 + kTileRows / 2 * down_.u_q16) >> 4;
    cap.y_q12 = (track_.side.v_q16 + kTileRows / 2 * down_.v_q16) >> 4;
    cap.find(0);
    triangle_ = cap.triangle;
    return true;
}

void TileWalker::set(const LatticePoint& begin, const TileChange& by, int width_log2)
{
    SpanSide& side = track_.side;
    side.u_q16 = begin.u_q16;
    side.v_q16 = begin.v_q16;
    side.du_q16 = by.across.u_q16 >> width_log2;
    side.dv_q16 = by.across.v_q16 >> width_log2;
    down_ = {by.down.u_q16 >> kTileRowsLog2, by.down.v_q16 >> kTileRowsLog2,
             by.twist.u_q16 >> (width_log2 + kTileRowsLog2), by.twist.v_q16 >> (width_log2 + kTileRowsLog2)};
}

void TileWalker::follow_cap()
{
    track_.cap.triangle = triangle_;
    track_.follow_cap();
}

int32_t TileWalker::highest(int32_t width) const
{
    SpanSide row = track_.side;
    const int32_t top = row.highest(width);
    row.move_down(down_, kTileRows - 1);
    const int32_t bottom = row.highest(width);
    return top > bottom ? top : bottom;
}

}  // namespace lumi
