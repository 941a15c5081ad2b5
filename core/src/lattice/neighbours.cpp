// SPDX-License-Identifier: MIT
#include "lattice/lattice_query.h"
#include "lattice/local_distances.h"
#include "lumi/detail/lattice.h"

namespace lumi::detail
{
namespace
{

// Squared distance in the units of Neighbour, for any two places. Halves: differences of opposite places fit.
uint32_t distance2(const Lattice& lattice, const Vec3q30& a, const Vec3q30& b)
{
    const Vec3q30 way = {(a.x >> 1) - (b.x >> 1), (a.y >> 1) - (b.y >> 1), (a.z >> 1) - (b.z >> 1)};
    const uint64_t units = static_cast<uint64_t>(dot_q60(way, way)) >> (58 - 2 * lattice.unit_bits());
    return units < UINT32_MAX ? static_cast<uint32_t>(units) : UINT32_MAX;
}

// The nearest points seen so far, nearest first; only such as are nearer than a limit.
struct Ranking {
    Neighbour* out;
    uint32_t capacity;
    uint32_t limit2;
    uint32_t count = 0;

    void consider(const Neighbour& candidate)
    {
        if (candidate.distance2 >= limit2) return;
        uint32_t k = count < capacity ? count++ : capacity - 1;
        for (; k > 0 && candidate.distance2 < out[k - 1].distance2; --k) out[k] = out[k - 1];
        out[k] = candidate;
        if (count == capacity) limit2 = out[capacity - 1].distance2;
    }
};

void scan(const Lattice& lattice, const Query& query, const Vec3q30& direction, uint32_t end, Ranking& ranking)
{
    LUMI_TALLY(Work::scanned, end);
    for (uint32_t i = 0; i < end; ++i) {
        const uint32_t index = unmirrored(lattice, query, i);
        ranking.consider({index, distance2(lattice, point(lattice, index), direction)});
    }
}

// A lattice line beyond the query's cell is looked at where the query is nearer than this to the cell's edge, as a
// share of the cell. The nearest point is a corner of the cell itself. Measured as the smallest that agrees with brute
// force, tests/core/lattice/lattice_test.cpp.
constexpr int32_t kNearestMargin = 0;
constexpr int32_t kKernelMarginQ12 = 1640;

// Walks the lattice lines from the query's cell on, along one coordinate.
struct Lines {
    int32_t first, last;
};

Lines lines_around(int32_t coordinate_q12, int32_t margin_q12)
{
    const int32_t part_q12 = coordinate_q12 & 4095;
    return {part_q12 < margin_q12 ? -1 : 0, part_q12 > 4096 - margin_q12 ? 2 : 1};
}

void scan_cells(const Lattice& lattice, const Query& query, int32_t margin_q12, Ranking& ranking)
{
    const Cell cell = cell_of(query);
    const Lines along = lines_around(cell.u_q12, margin_q12);
    const Lines across = lines_around(cell.v_q12, margin_q12);
    const LocalDistances distances(lattice, query, cell);
    LocalDistances::Way row = distances.corner();
    if (along.first < 0) row = row - distances.first();
    if (across.first < 0) row = row - distances.second();
    for (int32_t b = across.first; b <= across.last; ++b, row = row + distances.second()) {
        LocalDistances::Way at = row;
        for (int32_t a = along.first; a <= along.last; ++a, at = at + distances.first()) {
            const auto i = static_cast<uint32_t>(at.index);
            if (i < lattice.size()) ranking.consider({unmirrored(lattice, query, i), distances.distance2(at)});
        }
    }
}

// Points around a pole that may be within a spacing of a query nearer to it than kCapHeight: with a point's area as π,
// point i lies at sqrt(i + 1/2), and the spacing is sqrt(π).
constexpr uint32_t kCapPoints = 22;

void search(const Lattice& lattice, const Vec3q30& direction, int32_t margin_q12, Ranking& ranking)
{
    const Query query = make_query(lattice, direction);
    if (lattice.size() < kSmallSize)
        scan(lattice, query, direction, lattice.size(), ranking);
    else if (query.height_q10 < kCapHeight << 10)
        scan(lattice, query, direction, kCapPoints, ranking);
    else
        scan_cells(lattice, query, margin_q12, ranking);
}

}  // namespace

uint32_t nearest_of_all(const Lattice& lattice, const Vec3q30& direction, uint32_t count, Neighbour* out)
{
    Ranking ranking{out, count, UINT32_MAX};
    scan(lattice, make_query(lattice, direction), direction, lattice.size(), ranking);
    return ranking.count;
}

uint32_t nearest(const Lattice& lattice, const Vec3q30& direction)
{
    Neighbour result{};
    Ranking ranking{&result, 1, UINT32_MAX};
    search(lattice, direction, kNearestMargin, ranking);
    return result.index;
}

uint32_t kernel_points(const Lattice& lattice, const Vec3q30& direction, uint32_t count, Neighbour* out)
{
    Ranking ranking{out, count, lattice.spacing2()};
    search(lattice, direction, kKernelMarginQ12, ranking);
    return ranking.count;
}

void kernel_weights(const Lattice& lattice, const Neighbour* near, uint32_t count, uint32_t* weight_q12)
{
    const uint32_t radius2 = lattice.spacing2();
    uint32_t weight[kMaxNeighbours];
    uint32_t sum = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t inside = (radius2 - near[k].distance2) >> 13;  // < 2^15
        weight[k] = (inside * inside) >> 4;                           // < 2^26
        sum += weight[k];
    }
    // One division a query, of 16 bits of the sum. The nearest point is well within the radius, so it is not zero.
    const int shift = __builtin_clz(sum);
    const uint32_t scale_q16 = UINT32_MAX / ((sum << shift) >> 16);  // [2^16, 2^17]
    uint32_t rest = kWeightOneQ12;
    for (uint32_t k = count - 1; k > 0; --k) {
        weight_q12[k] = (((weight[k] << shift) >> 17) * scale_q16) >> 19;
        rest -= weight_q12[k];
    }
    weight_q12[0] = rest;
}

}  // namespace lumi::detail
