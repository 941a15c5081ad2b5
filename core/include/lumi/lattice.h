// SPDX-License-Identifier: MIT
// The Spherical Fibonacci point set and its inverse: the one definition that baker, renderer and tests share.
//
// Point i of n:  z = 1 - (2i+1)/n,  longitude = frac(i/Φ) turns, counted from +x towards +y.
// Index 0 lies next to the north pole (+z). Fink et al., "LumiPath", MICCAI 2019, section 2.1; Keinert et al.,
// "Spherical Fibonacci Mapping", ACM TOG 34(6), 2015. The mirror image i -> n-1-i maps the set onto itself.
//
// Accuracy: positions are within 2^-26 of the real numbers for every n up to kMaxLatticeSize.
#pragma once

#include "lumi/fixed.h"

namespace lumi {

inline constexpr uint32_t kMaxLatticeSize = uint32_t{1} << 20;
inline constexpr int kMaxNeighbours = 9;

// The constants of a point set of `size` points; 1 <= size <= kMaxLatticeSize (asserted by the caller).
// Construction divides once; everything else is free of division.
class Lattice {
public:
    Lattice() : Lattice(1) {}
    explicit Lattice(uint32_t size);

    uint32_t size() const { return size_; }

    // z of point i, Q30.
    int32_t height_q30(uint32_t i) const;
    // The real-valued index t = n(1-z)/2 - 1/2 at height z, Q10; the inverse of height_q30. In [-1/2, n-1/2].
    int32_t index_at_q10(int32_t z_q30) const;
    // The square of the mean point spacing, 4π/n, as raw·2^-exponent() of the distances in Neighbour: see there.
    uint32_t spacing2() const { return spacing2_; }
    int distance_shift() const { return distance_shift_; }

private:
    uint32_t size_;
    uint64_t step_q62_;  // 1/n
    uint32_t spacing2_;
    int distance_shift_;
};

// Longitude of point i; the same for every n. i < kMaxLatticeSize.
uint32_t longitude_turns32(uint32_t i);

// Position of point i on the unit sphere.
Vec3q30 point(const Lattice& lattice, uint32_t i);

// A lattice point near a query. `distance2` is the squared chord length in units of (2^(shift-30))², with
// shift = lattice.distance_shift(), so that the mean spacing is between 2^11 and 2^13 units for every n.
struct Neighbour {
    uint32_t index;
    uint32_t distance2;
};

// The `count` points nearest to the unit vector `direction`, nearest first, by true distance in space; ties by
// scan order. Returns how many were written: min(count, n). 1 <= count <= kMaxNeighbours. Constant time.
int neighbours(const Lattice& lattice, const Vec3q30& direction, int count, Neighbour* out);

// The nearest point alone.
uint32_t nearest(const Lattice& lattice, const Vec3q30& direction);

// The corners of a triangle of the lattice around a direction, with barycentric weights in Q12 that sum to 4096.
// Corners may repeat, with weight zero, where n < 3.
inline constexpr uint32_t kWeightOneQ12 = 4096;
struct Triangle {
    uint32_t index[3];
    uint32_t weight_q12[3];
};
Triangle triangle(const Lattice& lattice, const Vec3q30& direction);

}  // namespace lumi
