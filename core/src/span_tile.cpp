// SPDX-License-Identifier: MIT
#include "lumi/span_tile.h"

#include "lumi/always_inline.h"

namespace lumi
{
namespace
{

constexpr int32_t kTwoThirdsQ8 = 171;

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
    // Indices depend on heights alone: moving the tile by its middle's rise changes them by no more than that height,
    // and rounding by less than two.
    const int32_t mean_z =
        (top_left.z_q30 >> 2) + (top_right.z_q30 >> 2) + (bottom_left.z_q30 >> 2) + (bottom_right.z_q30 >> 2);
    const int32_t limit = chart.limit_z_q30() - magnitude(centre.z_q30 - mean_z) - 4 * chart.lattice().step_z_q30;
    if (limit < 0) return false;
    if (!within(top_left.z_q30, limit) || !within(top_right.z_q30, limit) || !within(bottom_left.z_q30, limit) ||
        !within(bottom_right.z_q30, limit))
        return false;

    const int32_t longitude_q20 = static_cast<int32_t>(top_left.longitude_turns32 >> 12);
    set_bilinear(
        {chart.at(longitude_q20, top_left.z_q30), chart.at(longitude_q20 + turns[0], top_right.z_q30),
         chart.at(longitude_q20 + turns[1], bottom_left.z_q30), chart.at(longitude_q20 + turns[2], bottom_right.z_q30),
         chart.at(longitude_q20 + turn_q20(centre), centre.z_q30)},
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
    set_bilinear({track_.in_plane(*nodes[0], mirrored), track_.in_plane(*nodes[1], mirrored),
                  track_.in_plane(*nodes[2], mirrored), track_.in_plane(*nodes[3], mirrored),
                  track_.in_plane(*nodes[4], mirrored)},
                 width_log2);
    // All rows look for their first triangle from the one under the middle of the left edge: none depends on others.
    SpanCap& cap = track_.cap;
    cap.triangle = 0;
    cap.x_q12 = (track_.side.u_q16 + kTileRows / 2 * down_.u_q16) >> 4;
    cap.y_q12 = (track_.side.v_q16 + kTileRows / 2 * down_.v_q16) >> 4;
    cap.find(0);
    triangle_ = cap.triangle;
    return true;
}

// Coordinates at a tile's corners and middle become those of its first row and how they change.
void TileWalker::set_bilinear(const TilePoints& at, int width_log2)
{
    const auto set = [&](int32_t LatticePoint::*p, int32_t& begin, int32_t& step, int32_t& down, int32_t& step_down) {
        // The middle of a tile lies off the plane between its corners by the most, two thirds of it in the mean.
        const int32_t a = at.top_left.*p;
        const int32_t b = at.top_right.*p;
        const int32_t c = at.bottom_left.*p;
        const int32_t d = at.bottom_right.*p;
        const int32_t rise = at.centre.*p - ((a + b + c + d) >> 2);
        begin = a + (((rise >> 3) * kTwoThirdsQ8) >> 5);
        step = (b - a) >> width_log2;
        down = (c - a) >> kTileRowsLog2;
        step_down = (((d - c) >> width_log2) - step) >> kTileRowsLog2;
    };
    SpanSide& side = track_.side;
    set(&LatticePoint::u_q16, side.u_q16, side.du_q16, down_.u_q16, down_.du_q16);
    set(&LatticePoint::v_q16, side.v_q16, side.dv_q16, down_.v_q16, down_.dv_q16);
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
    move_down(row, kTileRows - 1);
    const int32_t bottom = row.highest(width);
    return top > bottom ? top : bottom;
}

}  // namespace lumi
