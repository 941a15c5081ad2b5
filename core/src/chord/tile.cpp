// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/tile.h"

#include "lumi/detail/compiler.h"

namespace lumi::detail
{
namespace
{

// A quantity over a tile: at its first pixel, and what it changes by from its left edge to the right one, from its top
// to its bottom, and along its bottom more than along its top.
struct Bilinear {
    int32_t begin, across, down, twist;
    int32_t rise;  // how far the middle lies above the plane between the corners
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
    LUMI_TALLY(Work::tile_side, 1);
    const Hit& top_left = corners.top_left->*track_.hit;
    const Hit& top_right = corners.top_right->*track_.hit;
    const Hit& bottom_left = corners.bottom_left->*track_.hit;
    const Hit& bottom_right = corners.bottom_right->*track_.hit;
    const Hit& centre = corners.centre->*track_.hit;
    ZoneMap& map = track_.map;
    CellLine& line = track_.line.cells;
    if (!map.holds(centre.z_q30)) {
        if (!within(centre.z_q30, map.zones().polar_z_q30)) return false;
        map.choose(centre.z_q30, line);
    }
    const auto turn_q20 = [&](const Hit& hit) {
        return static_cast<int32_t>(hit.longitude_turns32 - top_left.longitude_turns32) >> 12;
    };
    const int32_t turns[] = {turn_q20(top_right), turn_q20(bottom_left), turn_q20(bottom_right)};
    if (!within(turns[0], kMaxTurnQ20) || !within(turns[1], kMaxTurnQ20) || !within(turns[2], kMaxTurnQ20))
        return false;
    const auto z_q25 = [](const Hit& hit) { return hit.z_q30 >> 5; };
    const int32_t z_of[] = {z_q25(top_left), z_q25(top_right), z_q25(bottom_left), z_q25(bottom_right)};
    const Bilinear z = bilinear(z_of[0], z_of[1], z_of[2], z_of[3], z_q25(centre));
    // Indices depend on heights alone: moving the tile by its middle's rise changes them by no more than that height.
    // Rounding does by less than five: at 65,536 points and steps of 233 and 377, 1.8 by floors of four heights in Q16,
    // 1.3 by floors of steps, 1.9 in BothSidesScanlines; by less than two and a height of 6/65536 for all sizes.
    constexpr int32_t kRoundingQ25 = 6 << 9;
    const int32_t spare_q25 = magnitude(z.rise) + (map.zones().step_z_q30 >> 3) + kRoundingQ25;
    const int32_t lowest_q25 = (map.lowest_z_q30() >> 5) + spare_q25;
    const int32_t highest_q25 = (map.highest_z_q30() >> 5) - spare_q25;
    if (lowest_q25 > highest_q25) return false;
    for (const int32_t corner_q25 : z_of)
        if (static_cast<uint32_t>(corner_q25 - lowest_q25) > static_cast<uint32_t>(highest_q25 - lowest_q25))
            return false;
    constexpr int32_t kMostTwistQ25 = 2 << 25;  // no view comes near it; products with scales stay below 2^31
    if (!within(z.twist, kMostTwistQ25)) return false;

    const Bilinear longitude = bilinear(0, turns[0], turns[1], turns[2], turn_q20(centre));
    const LatticePoint begin =
        map.at(static_cast<int32_t>(top_left.longitude_turns32 >> 12) + longitude.begin, z.begin >> 9);
    const LatticePoint across = map.change(longitude.across, z.across >> 9);
    const LatticePoint down = map.change(longitude.down, z.down >> 9);
    const LatticePoint twist = map.change(longitude.twist, z.twist >> 9);
    line.u_q16 = begin.u_q16;
    line.v_q16 = begin.v_q16;
    line.du_q16 = across.u_q16 >> width_log2;
    line.dv_q16 = across.v_q16 >> width_log2;
    line.uniform = map.is_uniform_at(top_left.z_q30) && map.is_uniform_at(top_right.z_q30) &&
                   map.is_uniform_at(bottom_left.z_q30) && map.is_uniform_at(bottom_right.z_q30);
    down_ = {down.u_q16 >> kTileHeightLog2, down.v_q16 >> kTileHeightLog2,
             twist.u_q16 >> (width_log2 + kTileHeightLog2), twist.v_q16 >> (width_log2 + kTileHeightLog2)};
    track_.line.over_pole = false;
    return true;
}

int32_t TileWalker::highest(int32_t width) const
{
    CellLine line = track_.line.cells;
    const int32_t top = line.highest(width);
    line.move_down(down_, kTileHeight - 1);
    const int32_t bottom = line.highest(width);
    return top > bottom ? top : bottom;
}

}  // namespace lumi::detail
