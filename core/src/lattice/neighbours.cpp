// SPDX-License-Identifier: MIT
#include "lattice/lattice_query.h"
#include "lumi/detail/lattice.h"

namespace lumi::detail
{
namespace
{

// Squared distance in the units of Neighbour.
uint32_t distance2(const Lattice& lattice, const Vec3q30& a, const Vec3q30& b)
{
    const int shift = lattice.distance_shift() - 1;
    const int32_t dx = ((a.x >> 1) - (b.x >> 1)) >> shift;
    const int32_t dy = ((a.y >> 1) - (b.y >> 1)) >> shift;
    const int32_t dz = ((a.z >> 1) - (b.z >> 1)) >> shift;
    return static_cast<uint32_t>(dx * dx) + static_cast<uint32_t>(dy * dy) + static_cast<uint32_t>(dz * dz);
}

// The nearest points seen so far, nearest first.
struct Ranking {
    const Lattice& lattice;
    const Query& query;
    const Vec3q30& direction;
    Neighbour* out;
    uint32_t capacity;
    uint32_t count = 0;

    void consider(int32_t i)
    {
        if (i < 0 || static_cast<uint32_t>(i) >= lattice.size()) return;
        const uint32_t index = unmirrored(lattice, query, static_cast<uint32_t>(i));
        insert({index, distance2(lattice, point(lattice, index), direction)});
    }

    void insert(const Neighbour& candidate)
    {
        uint32_t k = count < capacity ? count++ : capacity;
        if (k == capacity && candidate.distance2 >= out[--k].distance2) return;
        for (; k > 0 && candidate.distance2 < out[k - 1].distance2; --k) out[k] = out[k - 1];
        out[k] = candidate;
    }
};

// How far to look for `count` neighbours. Distances in the polar pattern's unit (a point covers an area of π);
// measured as the smallest that agree with brute force, tests/core/lattice_test.cpp.
struct SearchRange {
    int32_t block_low, block_high;  // lattice coordinates around the query's, in u and v
    int32_t rounding_q12;           // 1/2 where the block is centred on a point, 0 where on a cell
    int32_t cap_height;             // nearer to the pole than this, every point of a ring is looked at
    int32_t reach_q12;              // half width of that ring
};

SearchRange search_range(uint32_t count)
{
    if (count == 1) return {-1, 1, 2048, 16, 6144};
    if (count <= 4) return {-1, 2, 0, 12, 10240};
    if (count == 5) return {-1, 2, 0, 24, 16384};
    return {-2, 3, 0, 24, 16384};
}

void scan_ring(Ranking& ranking, const SearchRange& range)
{
    const int32_t radius_q12 = polar_radius_q12(ranking.query);
    const int32_t inner_q12 = radius_q12 > range.reach_q12 ? radius_q12 - range.reach_q12 : 0;
    const int32_t outer_q12 = radius_q12 + range.reach_q12;
    const int32_t last = static_cast<int32_t>(wide_product(outer_q12, outer_q12) >> 24);
    for (int32_t i = static_cast<int32_t>(wide_product(inner_q12, inner_q12) >> 24); i <= last; ++i)
        ranking.consider(i);
}

void scan_all(Ranking& ranking)
{
    for (uint32_t i = 0; i < ranking.lattice.size(); ++i) ranking.consider(static_cast<int32_t>(i));
}

void scan_block(Ranking& ranking, const SearchRange& range)
{
    const Cell cell = cell_of(ranking.query);
    const int32_t a = (cell.u_q12 + range.rounding_q12) >> 12;
    const int32_t b = (cell.v_q12 + range.rounding_q12) >> 12;
    for (int32_t db = range.block_low; db <= range.block_high; ++db)
        for (int32_t da = range.block_low; da <= range.block_high; ++da)
            ranking.consider(cell.first * (a + da) + cell.second * (b + db));
}

}  // namespace

uint32_t neighbours(const Lattice& lattice, const Vec3q30& direction, uint32_t count, Neighbour* out)
{
    const Query query = make_query(lattice, direction);
    const SearchRange range = search_range(count);
    Ranking ranking{lattice, query, direction, out, count};
    if (lattice.size() < kSmallSize)
        scan_all(ranking);
    else if (query.height_q10 < range.cap_height << 10)
        scan_ring(ranking, range);
    else
        scan_block(ranking, range);
    return ranking.count;
}

uint32_t nearest(const Lattice& lattice, const Vec3q30& direction)
{
    Neighbour result;
    neighbours(lattice, direction, 1, &result);
    return result.index;
}

void kernel_weights(const Lattice& lattice, const Neighbour* near, uint32_t count, uint32_t* weight_q12)
{
    const uint32_t radius2 = lattice.spacing2();
    uint32_t weight[kMaxNeighbours];
    uint32_t sum = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t inside = near[k].distance2 < radius2 ? (radius2 - near[k].distance2) >> 9 : 0;  // < 2^15
        weight[k] = (inside * inside) >> 4;                                                            // < 2^26
        sum += weight[k];
    }
    // sum < 9·2^26; one division a query. Every direction has a point well within the radius, so sum is not zero.
    const uint32_t scale = static_cast<uint32_t>((uint64_t{1} << 44) / sum);
    uint32_t rest = kWeightOneQ12;
    for (uint32_t k = count - 1; k > 0; --k) {
        weight_q12[k] = static_cast<uint32_t>((static_cast<uint64_t>(weight[k]) * scale) >> 32);
        rest -= weight_q12[k];
    }
    weight_q12[0] = rest;
}

}  // namespace lumi::detail
