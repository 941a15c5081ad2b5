// SPDX-License-Identifier: MIT
// The Spherical Fibonacci point set and its inverse: the one definition that baker, renderer and tests share.
//
// Point i of n:  z = 1 - (2i+1)/n,  longitude = frac(i/Φ) turns, counted from +x towards +y.
// Index 0 lies next to the north pole (+z). Fink et al., "LumiPath", MICCAI 2019, section 2.1; Keinert et al.,
// "Spherical Fibonacci Mapping", ACM TOG 34(6), 2015. The mirror image i -> n-1-i maps the set onto itself.
//
// Accuracy: positions are within 2^-22 of the real numbers for every n up to kMaxLatticeSize: 1/14,000 of the mean
// point spacing at the largest n, worst next to its poles.
#pragma once

#include "lumi/detail/work.h"
#include "lumi/fixed.h"

namespace lumi::detail
{

inline constexpr uint32_t kMaxLatticeSize = uint32_t{1} << 20;
inline constexpr uint32_t kMaxNeighbours = 9;

// The constants of a point set of `size` points; 1 <= size <= kMaxLatticeSize (asserted by the caller).
// Construction divides once; everything else is free of division.
class Lattice
{
public:
    constexpr Lattice() = default;  // no points yet: to be assigned
    explicit Lattice(uint32_t size);

    uint32_t size() const { return size_; }

    // Returns z of point i, Q30.
    int32_t height_q30(uint32_t i) const;
    // Returns z at a real-valued index, Q10 to Q30; -1/2 <= index <= n - 1/2.
    int32_t height_at_q30(int32_t index_q10) const;
    // Returns the real-valued index t = n(1-z)/2 - 1/2 at height z, Q10; the inverse of height_q30. In [-1/2, n-1/2].
    int32_t index_at_q10(int32_t z_q30) const;
    // Returns the square of the mean point spacing, 4π/n (the area of a point), in the units of Neighbour. In [2^26,
    // 2^28).
    uint32_t spacing2() const { return spacing2_; }
    // A unit of Neighbour is 2^-unit_bits of the radius.
    int unit_bits() const { return unit_bits_; }
    // By how much a point lies south of the one before, in these units, Q14. At most 2^24 for 64 points and more.
    int32_t index_step_q14() const { return static_cast<int32_t>(reciprocal_q62_ >> (47 - unit_bits_)); }
    // 1/n, Q30, rounded down.
    uint32_t reciprocal_q30() const { return static_cast<uint32_t>(reciprocal_q62_ >> 32); }

private:
    uint32_t size_ = 0;
    uint64_t reciprocal_q62_ = 0;  // 1/n
    uint32_t spacing2_ = 0;
    int unit_bits_ = 0;
};

// Longitude of point i; the same for every n. -kMaxLatticeSize < i < kMaxLatticeSize: steps between points have one,
// too.
uint32_t longitude_turns32(uint32_t i);

// Returns the position of point i on the unit sphere.
Vec3q30 point(const Lattice& lattice, uint32_t i);

// A lattice point near a query. `distance2` is the squared chord length in units of 2^-unit_bits, chosen so that the
// mean spacing is between 2^13 and 2^14 units for every n.
struct Neighbour {
    uint32_t index;
    uint32_t distance2;
};

// The nearest point to the unit vector `direction` by true distance in space: another one only where both distances
// differ by less than 1/1000 of the mean spacing. Constant time: looks at the corners of one cell, near a pole at 22
// points, below 64 points at all.
uint32_t nearest(const Lattice& lattice, const Vec3q30& direction);

// The paper's kernel: weights that fall from 1 at the query to 0 at the mean spacing, R·⁴√5·√(4π/(√5·n)) = R·√(4π/n),
// as (1 - d²/r²)².
//
// Finds the points nearer than the mean spacing, nearest first; the nearest `count` where there are more. Returns how
// many were written: 1 at least. 1 <= count <= kMaxNeighbours. Looks at 4 to 9 points, otherwise as above.
uint32_t kernel_points(const Lattice& lattice, const Vec3q30& direction, uint32_t count, Neighbour* out);

// Their weights, normalised to kWeightOneQ12; the nearest takes what rounding leaves.
inline constexpr uint32_t kWeightOneQ12 = 4096;
void kernel_weights(const Lattice& lattice, const Neighbour* near, uint32_t count, uint32_t* weight_q12);

// The corners of the lattice triangle around a direction, with barycentric weights that sum to kWeightOneQ12.
//
// Weights are continuous over the whole sphere, for every n: over a step of 1/10,000 of the mean spacing they change by
// less than 1/500 in all (0.5 levels of 255), most of it rounding. One triangulation covers the sphere. With t the
// real-valued index from the nearer pole, weights are linear in longitude and height for t >= 24, and in the pole's
// Lambert plane for t < 20. In between, longitude and height go over, linearly in t, from those that the plane's
// weights give to the direction's own. Below 64 points the patterns of both poles overlap: the triangle is the one of
// the points' convex hull that the direction points at, with weights linear in its plane. Below 4 points weights are
// linear in height between the two points whose heights are next.
struct Triangle {
    uint32_t index[3];
    uint32_t weight_q12[3];
};
Triangle triangle(const Lattice& lattice, const Vec3q30& direction);

// The one definition of which triangle of a lattice cell a point lies in. Loops that draw both sides at once choose the
// same triangles by the halves of words (chord/detail/both_sides_steps.h) or by branches (src/chord/armv6m).
//
// The triangle of a cell around fractions fu, fv in [0, one): which of its corners are taken, and their weights.
// Cells are cut along the sum of both steps, or flipped: along their difference.
struct CellTriangle {
    int32_t first[3], second[3];  // how often a corner lies a first and a second step on
    int32_t weight[3];

    static CellTriangle of(int32_t fu, int32_t fv, int32_t one, bool flipped)
    {
        if (flipped && fu + fv >= one) return {{1, 1, 0}, {1, 0, 1}, {fu + fv - one, one - fv, one - fu}};
        if (flipped) return {{0, 1, 0}, {0, 0, 1}, {one - fu - fv, fu, fv}};
        if (fu > fv) return {{0, 1, 1}, {0, 0, 1}, {one - fu, fu - fv, fv}};
        return {{0, 0, 1}, {0, 1, 1}, {one - fv, fv - fu, fu}};
    }
};

}  // namespace lumi::detail
