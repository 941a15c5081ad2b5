// SPDX-License-Identifier: MIT
// The lattice around a pole, where longitude and height stop being usable coordinates.
//
// Under Lambert's azimuthal equal-area projection, scaled so that a point covers an area of π, point i of *every*
// Spherical Fibonacci set lies at radius sqrt(i + 1/2) and longitude i/Φ: one planar pattern for all n. Its Delaunay
// triangles are therefore constants. tests/core/lattice/polar_test.cpp recomputes them by brute force.
#pragma once

#include <stdint.h>

#include "math/generate.h"

namespace lumi::detail::polar
{

// Triangles cover the disc of radius sqrt(kReach + 1/2): all directions whose real-valued index is below kReach. From
// index 14 on they are the triangles of the cells of zone 6, steps 8 and 13: those that begin at index 9 or above are
// obtuse.
inline constexpr int32_t kReach = 24;
inline constexpr uint32_t kPoints = 45;
inline constexpr int kTriangles = 67;
inline constexpr int32_t kWalkReach = 23;  // PolarLine walks so far
inline constexpr int kWalkTriangles = 65;  // those with a corner below kWalkReach: they come first

// Up to kBlendBegin, a real-valued index, directions count by their place in the plane, from kBlendEnd on by longitude
// and height. In between one goes over into the other (triangle.cpp).
inline constexpr int32_t kBlendBegin = 20;
inline constexpr int32_t kBlendEnd = 24;
static_assert(kBlendEnd <= kReach);

struct PlanePoint {
    int32_t x_q12, y_q12;
};

struct Pattern {
    PlanePoint point[kPoints];
};

constexpr int32_t round_q12(double v)
{
    return static_cast<int32_t>(v * 4096 + (v < 0 ? -0.5 : 0.5));
}

constexpr Pattern make_pattern()
{
    Pattern pattern{};
    for (uint32_t i = 0; i < kPoints; ++i) {
        const double radius = generate::root(i + 0.5);
        const double angle = 2 * generate::kPi * (generate::fraction(i / generate::kGolden) - 0.5);  // -π .. π, turned
        pattern.point[i] = {round_q12(-radius * generate::sine(angle + generate::kPi / 2)),
                            round_q12(-radius * generate::sine(angle))};
    }
    return pattern;
}

inline constexpr Pattern kPattern = make_pattern();

// Returns point i < kPoints of the pattern.
inline PlanePoint plane_point(uint32_t i)
{
    return kPattern.point[i];
}

inline constexpr uint8_t kNone = 255;

// How a weight changes along x and y.
struct Gradient {
    int16_t x_q14, y_q14;
};

// Walking needs this, apart from the corners: render(), which does not walk, links those alone.
struct TriangleWalk {
    uint8_t beyond[3];   // the triangles across the edges opposite the corners; kNone where the pattern's table ends
    Gradient weight[2];  // barycentric, of the corners 1 and 2; both are 0 at corner 0. Shorter than 1
};

struct Walks {
    TriangleWalk triangle[kWalkTriangles];
};

// Triangle k's corners: counter-clockwise, the lowest index first; triangles come in the order of that index.
extern const uint8_t kCorners[kTriangles][3];
extern const Walks kWalks;

// Returns the corners of triangle k < kTriangles.
inline const uint8_t* corners(int k)
{
    return kCorners[k];
}

// Returns the triangles beyond the edges of triangle k < kWalkTriangles.
inline const uint8_t* beyond(int k)
{
    return kWalks.triangle[k].beyond;
}

}  // namespace lumi::detail::polar
