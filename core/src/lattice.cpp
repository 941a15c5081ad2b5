// SPDX-License-Identifier: MIT
#include "lumi/lattice.h"

#include "generate.h"
#include "lumi/math.h"
#include "polar.h"

namespace lumi
{
namespace
{

// Fibonacci numbers F_0 .. F_16. Zone 15 also serves the equator of n = 2^20, where Keinert's zone would be 16: the
// cells' triangles are the same.
constexpr int32_t kFibonacci[17] = {0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 233, 377, 610, 987};
constexpr int kZones = 16;

struct ZoneTables {
    uint32_t threshold_q10[2 * kZones];  // n·(1 - z²) = Φ^m/(√5·π)
    int32_t step_turns_q30[kZones + 1];  // |longitude step of F_k| = Φ^-k
};

constexpr ZoneTables make_zone_tables()
{
    ZoneTables t{};
    double power = 1;
    double inverse = 1;
    for (int m = 0; m < 2 * kZones; ++m) {
        t.threshold_q10[m] = static_cast<uint32_t>(1024 * power / (generate::root(5) * generate::kPi) + 0.5);
        power *= generate::kGolden;
    }
    for (int k = 0; k <= kZones; ++k) {
        t.step_turns_q30[k] = k == 0 ? kOneQ30 : static_cast<int32_t>(kOneQ30 * inverse + 0.5);
        inverse /= generate::kGolden;
    }
    return t;
}

constexpr ZoneTables kZoneTables = make_zone_tables();

// Below this size every point is looked at: the pattern of one pole reaches into the other's.
constexpr uint32_t kSmallSize = 64;

// A query in the northern hemisphere; the south is its mirror image i -> n-1-i.
struct Query {
    uint32_t longitude_turns32;
    int32_t height_q10;  // real-valued index t
    int32_t z_q30;       // in [0, 1]
    bool mirrored;
};

int32_t clamp_q30(int32_t v)
{
    return v > kOneQ30 ? kOneQ30 : v < -kOneQ30 ? -kOneQ30 : v;
}

Query make_query(const Lattice& lattice, const Vec3q30& d)
{
    const uint32_t longitude = angle_turns32(d.y, d.x);
    const int32_t z = clamp_q30(d.z);
    if (z >= 0) return {longitude, lattice.index_at_q10(z), z, false};
    return {longitude_turns32(lattice.size() - 1) - longitude, lattice.index_at_q10(-z), -z, true};
}

uint32_t unmirrored(const Lattice& lattice, const Query& query, uint32_t i)
{
    return query.mirrored ? lattice.size() - 1 - i : i;
}

// n·(1 - z²) at the real-valued index t, Q10: (2t + 1)·(1 + z) with z >= 0.
uint32_t n_sine2_q10(int32_t height_q10, int32_t z_q30)
{
    const uint64_t twice = static_cast<uint64_t>(2 * static_cast<int64_t>(height_q10) + 1024);
    return static_cast<uint32_t>((twice * (static_cast<uint32_t>(z_q30) + static_cast<uint32_t>(kOneQ30))) >> 30);
}

// Keinert's zone: the k with Φ^2k <= √5·π·n·(1 - z²) < Φ^(2k+2), where F_k and F_k+1 are the shortest steps.
int zone_of(const Query& q)
{
    const uint32_t n_sine2 = n_sine2_q10(q.height_q10, q.z_q30);
    int k = 1;
    while (k + 1 < kZones && n_sine2 >= kZoneTables.threshold_q10[2 * (k + 1)]) ++k;
    return k;
}

// Lattice coordinates of a query in the basis (F_k, F_k+1) of its zone: the point with coordinates (a, b) has index
// F_k·a + F_k+1·b. The basis has determinant ±1, and adding a turn to the longitude moves (u, v) by (F_k+1, -F_k),
// which leaves every index as it is.
struct Cell {
    int zone;
    int32_t first, second;  // F_k, F_k+1
    int32_t u_q12, v_q12;
};

Cell cell_of(const Query& q)
{
    const int k = zone_of(q);
    const int64_t odd_sign = (k & 1) != 0 ? 1 : -1;
    const int32_t first = kFibonacci[k];
    const int32_t second = kFibonacci[k + 1];
    const auto along_longitude = [&](int32_t fibonacci) {
        return odd_sign * static_cast<int64_t>(
                              (static_cast<uint64_t>(q.longitude_turns32) * static_cast<uint32_t>(fibonacci)) >> 20);
    };
    const auto along_height = [&](int32_t step_q30) { return (static_cast<int64_t>(q.height_q10) * step_q30) >> 28; };
    return {k, first, second,
            static_cast<int32_t>(along_longitude(second) + along_height(kZoneTables.step_turns_q30[k + 1])),
            static_cast<int32_t>(along_height(kZoneTables.step_turns_q30[k]) - along_longitude(first))};
}

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
    return {-2, 3, 0, 24, 16384};
}

// Distance of a query from the pole in the polar pattern, where point i lies at sqrt(i + 1/2).
int32_t polar_radius_q12(const Query& q)
{
    return static_cast<int32_t>(square_root(static_cast<uint64_t>(q.height_q10 + 512) << 14));
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
    for (int32_t db = range.block_low; db <= range.block_high; ++db) {
        for (int32_t da = range.block_low; da <= range.block_high; ++da) {
            ranking.consider(cell.first * (a + da) + cell.second * (b + db));
        }
    }
}

struct PolarPosition {
    int32_t x_q12, y_q12;
};

// A query in the plane of the polar pattern.
PolarPosition polar_position(const Query& q)
{
    const int32_t radius_q12 = polar_radius_q12(q);
    const SinCos direction = sin_cos(q.longitude_turns32);
    return {mul_q30(radius_q12, direction.cos_q30), mul_q30(radius_q12, direction.sin_q30)};
}

// Twice the area of the triangle (a, b, p), Q24.
int32_t area_q24(polar::PlanePoint a, polar::PlanePoint b, const PolarPosition& p)
{
    return (b.x_q12 - a.x_q12) * (p.y_q12 - a.y_q12) - (b.y_q12 - a.y_q12) * (p.x_q12 - a.x_q12);
}

// The parts into which a position divides a triangle of the polar pattern; a negative part: it lies outside.
struct PolarParts {
    const uint8_t* corners;
    int32_t area[3];

    int32_t smallest() const
    {
        const int32_t first = area[0] < area[1] ? area[0] : area[1];
        return first < area[2] ? first : area[2];
    }
};

PolarParts divide(int k, const PolarPosition& p)
{
    const uint8_t* c = polar::corners(k);
    const polar::PlanePoint p0 = polar::plane_point(c[0]);
    const polar::PlanePoint p1 = polar::plane_point(c[1]);
    const polar::PlanePoint p2 = polar::plane_point(c[2]);
    return {c, {area_q24(p1, p2, p), area_q24(p2, p0, p), area_q24(p0, p1, p)}};
}

// The triangle of the polar pattern that holds the query; where rounding leaves a gap, the one that misses it least.
Triangle polar_triangle(const Lattice& lattice, const Query& q)
{
    const PolarPosition position = polar_position(q);
    PolarParts best = divide(0, position);
    for (int k = 1; k < polar::kTriangles && best.smallest() < 0; ++k) {
        const PolarParts parts = divide(k, position);
        if (parts.smallest() > best.smallest()) best = parts;
    }
    uint32_t part[3];
    for (int m = 0; m < 3; ++m) part[m] = best.area[m] > 0 ? static_cast<uint32_t>(best.area[m]) >> 12 : 0;
    const uint32_t sum = part[0] + part[1] + part[2];
    const uint32_t w1 = part[1] * kWeightOneQ12 / sum;
    const uint32_t w2 = part[2] * kWeightOneQ12 / sum;
    return {{unmirrored(lattice, q, best.corners[0]), unmirrored(lattice, q, best.corners[1]),
             unmirrored(lattice, q, best.corners[2])},
            {kWeightOneQ12 - w1 - w2, w1, w2}};
}

// Whether the two steps of a zone form an obtuse angle at the middle of a cell: then the cell's diagonal is their sum,
// else their difference. Decided for the cell, not for the query, so that neighbours agree and no seam opens where the
// diagonal flips; where the zone changes, both zones' triangles are the same ones.
bool is_obtuse(const Lattice& lattice, const Cell& cell, int32_t corner)
{
    const int32_t middle_q10 = 1024 * corner + 512 * (cell.first + cell.second);
    const int32_t z_q30 = lattice.height_at_q30(middle_q10);
    return n_sine2_q10(middle_q10, z_q30) >= kZoneTables.threshold_q10[2 * cell.zone + 1];
}

// The triangle of a cell of the lattice, by its parts (fu, fv) and the diagonal that divides it.
Triangle cell_triangle(const Lattice& lattice, const Query& q)
{
    const Cell cell = cell_of(q);
    const int32_t corner = cell.first * (cell.u_q12 >> 12) + cell.second * (cell.v_q12 >> 12);
    const uint32_t fu = static_cast<uint32_t>(cell.u_q12) & (kWeightOneQ12 - 1);
    const uint32_t fv = static_cast<uint32_t>(cell.v_q12) & (kWeightOneQ12 - 1);
    const auto index = [&](int32_t i) { return unmirrored(lattice, q, static_cast<uint32_t>(i)); };
    const uint32_t first = index(corner + cell.first);
    const uint32_t second = index(corner + cell.second);
    const uint32_t near = index(corner);
    const uint32_t far = index(corner + cell.first + cell.second);
    if (is_obtuse(lattice, cell, corner)) {
        if (fu > fv) return {{near, first, far}, {kWeightOneQ12 - fu, fu - fv, fv}};
        return {{near, second, far}, {kWeightOneQ12 - fv, fv - fu, fu}};
    }
    if (fu + fv < kWeightOneQ12) return {{near, first, second}, {kWeightOneQ12 - fu - fv, fu, fv}};
    return {{far, first, second}, {fu + fv - kWeightOneQ12, kWeightOneQ12 - fv, kWeightOneQ12 - fu}};
}

// Too few points for a pattern: the nearest three, by the kernel's weights.
Triangle small_triangle(const Lattice& lattice, const Vec3q30& direction)
{
    Neighbour near[3];
    const uint32_t count = neighbours(lattice, direction, 3, near);
    for (uint32_t m = count; m < 3; ++m) near[m] = {near[0].index, lattice.spacing2()};
    Triangle result;
    kernel_weights(lattice, near, 3, result.weight_q12);
    for (int m = 0; m < 3; ++m) result.index[m] = near[m].index;
    return result;
}

}  // namespace

Lattice::Lattice(uint32_t size)
    : size_(size), reciprocal_q62_(((uint64_t{1} << 62) + size / 2) / size), spacing2_(0), distance_shift_(0)
{
    constexpr uint64_t kFourPiQ56 = 905502432259640355u;  // 4π
    const uint64_t spacing2_q56 = kFourPiQ56 / size;
    const uint32_t spacing_q28 = square_root(spacing2_q56);
    constexpr int kSpacingBits = 12;  // the spacing is in [2^11, 2^12) units
    distance_shift_ = 32 - __builtin_clz(spacing_q28) - kSpacingBits + 2;
    spacing2_ = static_cast<uint32_t>(spacing2_q56 >> (2 * distance_shift_ - 4));
}

int32_t Lattice::height_q30(uint32_t i) const
{
    return kOneQ30 - static_cast<int32_t>(((2 * i + 1) * reciprocal_q62_ + (uint64_t{1} << 31)) >> 32);
}

int32_t Lattice::height_at_q30(int32_t index_q10) const
{
    const uint64_t below_top_q10 = static_cast<uint64_t>(2 * static_cast<int64_t>(index_q10) + 1024);  // < 2^32
    return kOneQ30 - static_cast<int32_t>((below_top_q10 * (reciprocal_q62_ >> 10)) >> 32);
}

int32_t Lattice::index_at_q10(int32_t z_q30) const
{
    const uint64_t below_top = static_cast<uint64_t>(kOneQ30 - static_cast<int64_t>(z_q30)) * size_;  // Q30
    return static_cast<int32_t>(below_top >> 21) - 512;
}

uint32_t longitude_turns32(uint32_t i)
{
    // 2^32/Φ = 0x9E3779B9 + 0.4972…; the second product adds that fraction, 2036/4096.
    return i * 0x9E3779B9u + ((i * 2036u) >> 12);
}

Vec3q30 point(const Lattice& lattice, uint32_t i)
{
    const int32_t z = lattice.height_q30(i);
    const SinCos direction = sin_cos(longitude_turns32(i));
    const uint64_t radius2_q60 = (uint64_t{1} << 60) - static_cast<uint64_t>(wide_product(z, z));
    const int32_t radius = static_cast<int32_t>(square_root(radius2_q60));
    return {mul_q30(radius, direction.cos_q30), mul_q30(radius, direction.sin_q30), z};
}

uint32_t neighbours(const Lattice& lattice, const Vec3q30& direction, uint32_t count, Neighbour* out)
{
    const Query query = make_query(lattice, direction);
    const SearchRange range = search_range(count);
    Ranking ranking{lattice, query, direction, out, count};
    if (lattice.size() < kSmallSize) {
        scan_all(ranking);
    } else if (query.height_q10 < range.cap_height << 10) {
        scan_ring(ranking, range);
    } else {
        scan_block(ranking, range);
    }
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

Triangle triangle(const Lattice& lattice, const Vec3q30& direction)
{
    if (lattice.size() < kSmallSize) return small_triangle(lattice, direction);
    const Query query = make_query(lattice, direction);
    return query.height_q10 < polar::kCapHeight << 10 ? polar_triangle(lattice, query) : cell_triangle(lattice, query);
}

}  // namespace lumi
