// SPDX-License-Identifier: MIT
#include "lattice/polar_triangle.h"

#include "lattice/polar.h"
#include "lumi/detail/math.h"

namespace lumi::detail
{
namespace
{

struct PolarPosition {
    int32_t x_q12, y_q12;
};

// Lambert's projection of a unit vector: x and y, scaled by sqrt(n/(2·(1 + |z|))) = n/sqrt(2·n·(1 + |z|)).
PolarPosition projected(const Lattice& lattice, const Vec3q30& direction, int32_t height_z_q30)
{
    const uint64_t above_q30 = static_cast<uint64_t>(kOneQ30) + static_cast<uint32_t>(height_z_q30);
    const ReciprocalRoot root = reciprocal_root(2 * lattice.size() * above_q30);  // of 2^37 to 2^52 where n >= 64
    const auto scale_q20 = static_cast<int32_t>((uint64_t{lattice.size()} * root.mantissa) >> (root.exponent - 35));
    return {static_cast<int32_t>(wide_product(direction.x, scale_q20) >> 38),
            static_cast<int32_t>(wide_product(direction.y, scale_q20) >> 38)};
}

// A place around the south pole in the pattern: its mirror image i -> n-1-i.
PolarPosition mirrored(const Lattice& lattice, const PolarPosition& p)
{
    const SinCos mirror = sin_cos(longitude_turns32(lattice.size() - 1));
    return {mul_q30(p.x_q12, mirror.cos_q30) + mul_q30(p.y_q12, mirror.sin_q30),
            mul_q30(p.x_q12, mirror.sin_q30) - mul_q30(p.y_q12, mirror.cos_q30)};
}

// Twice the area of the triangle (a, b, p), Q24.
int32_t area_q24(polar::PlanePoint a, polar::PlanePoint b, const PolarPosition& p)
{
    return (b.x_q12 - a.x_q12) * (p.y_q12 - a.y_q12) - (b.y_q12 - a.y_q12) * (p.x_q12 - a.x_q12);
}

// The parts into which a position divides a triangle of the polar pattern; a negative part: it lies outside.
struct PolarParts {
    const uint8_t* corners;
    int32_t area_q24[3];
    int32_t smallest_q24;
};

// Takes triangle k if it holds the position, or misses it by less.
void improve(PolarParts& best, int k, const PolarPosition& p)
{
    const uint8_t* c = polar::corners(k);
    const polar::PlanePoint p0 = polar::plane_point(c[0]);
    const polar::PlanePoint p1 = polar::plane_point(c[1]);
    const int32_t opposite_2 = area_q24(p0, p1, p);
    if (opposite_2 <= best.smallest_q24) return;
    const polar::PlanePoint p2 = polar::plane_point(c[2]);
    const int32_t opposite_0 = area_q24(p1, p2, p);
    if (opposite_0 <= best.smallest_q24) return;
    const int32_t opposite_1 = area_q24(p2, p0, p);
    if (opposite_1 <= best.smallest_q24) return;
    const int32_t smaller = opposite_0 < opposite_1 ? opposite_0 : opposite_1;
    best = {c, {opposite_0, opposite_1, opposite_2}, smaller < opposite_2 ? smaller : opposite_2};
}

// Finds the triangle that holds the position or, where rounding leaves a gap, the one that misses it least.
PolarParts find(const PolarPosition& position)
{
    PolarParts best = {polar::corners(0), {0, 0, 0}, INT32_MIN};
    for (int k = 0; k < polar::kTriangles && best.smallest_q24 < 0; ++k) improve(best, k, position);
    return best;
}

}  // namespace

PolarTriangle polar_triangle(const Lattice& lattice, const Query& query, const Vec3q30& direction)
{
    const PolarPosition position = projected(lattice, direction, query.z_q30);
    const PolarParts found = find(query.mirrored ? mirrored(lattice, position) : position);
    uint32_t part[3];
    for (int m = 0; m < 3; ++m) part[m] = found.area_q24[m] > 0 ? static_cast<uint32_t>(found.area_q24[m]) >> 12 : 0;
    const uint32_t sum = part[0] + part[1] + part[2];
    const uint32_t w1 = part[1] * kWeightOneQ12 / sum;
    const uint32_t w2 = part[2] * kWeightOneQ12 / sum;
    return {found.corners, {kWeightOneQ12 - w1 - w2, w1, w2}};
}

Query blended(const Query& query, const PolarTriangle& weights)
{
    static_assert((polar::kBlendEnd - polar::kBlendBegin) << 10 == kWeightOneQ12, "heights in Q10 are shares in Q12");
    const int32_t share_q12 = (polar::kBlendEnd << 10) - query.height_q10;
    int32_t turns32 = 0;     // a triangle is less than 1/4 turn wide here
    int32_t height_q22 = 0;  // and its corners at most 21 indices away
    for (int m = 0; m < 3; ++m) {
        const auto weight_q12 = static_cast<int32_t>(weights.weight_q12[m]);
        const uint32_t corner = weights.corners[m];
        const auto turn = static_cast<int32_t>(longitude_turns32(corner) - query.longitude_turns32);
        turns32 += weight_q12 * (turn >> 12);
        height_q22 += weight_q12 * ((static_cast<int32_t>(corner) << 10) - query.height_q10);
    }
    Query moved = query;
    moved.longitude_turns32 += static_cast<uint32_t>((turns32 >> 12) * share_q12);
    moved.height_q10 += ((height_q22 >> 12) * share_q12) >> 12;
    return moved;
}

}  // namespace lumi::detail
