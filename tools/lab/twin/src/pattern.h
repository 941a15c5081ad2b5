// SPDX-License-Identifier: MIT
// The pattern of points around a pole, the same for every lattice, and its Delaunay triangles by brute force.
#pragma once

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "lumi/twin/geometry.h"
#include "lumi/twin/weights.h"

namespace lumi::twin
{

// Describes the lattice by longitude and height: zones and their coordinates, from the formulas of
// docs/chord-fields.md.

inline double fibonacci(int m)
{
    return std::round(std::pow(kGolden, m) / std::sqrt(5.0));
}

// A direction in the north: longitude in turns, and height as a real-valued index.
struct Place {
    double turns, height;
};

inline Place place_of(const Vec3& north, uint32_t n)
{
    return {std::atan2(north.y, north.x) / (2 * kPi), n * (1 - north.z) / 2 - 0.5};
}

// q, or its mirror image under i -> n-1-i if that is the one in the north.
inline Vec3 northern(const Vec3& q, uint32_t n)
{
    if (q.z >= 0) return q;
    const double angle = 2 * kPi * ((n - 1) / kGolden) - std::atan2(q.y, q.x);
    const double radius = std::sqrt(q.x * q.x + q.y * q.y);
    return {radius * std::cos(angle), radius * std::sin(angle), -q.z};
}

// Computes √5·π·n·(1 - z²) at a height.
inline double steepness(double height, uint32_t n)
{
    const double z = 1 - (2 * height + 1) / n;
    return std::sqrt(5.0) * kPi * n * (1 - z * z);
}

// The zone of a height, with the part of it that lies behind.
inline double zone_of(double height, uint32_t n)
{
    return std::log(steepness(height, n)) / std::log(kGolden) / 2;
}

// Computes lattice coordinates in the basis (F_k, F_k+1).
struct CellCoordinates {
    double u, v;
};

inline CellCoordinates coordinates(const Place& p, int k)
{
    const double sign = k % 2 != 0 ? 1 : -1;
    return {sign * fibonacci(k + 1) * p.turns + std::pow(kGolden, -k - 1) * p.height,
            std::pow(kGolden, -k) * p.height - sign * fibonacci(k) * p.turns};
}

class Pattern
{
public:
    Pattern();

    // Barycentric weights in the triangle that holds a place, in Lambert's plane. Precondition: height < kReach.
    Weights weights(const Place& place) const;

    // Whether two points share a triangle. One of them must be below kReach.
    bool has_edge(uint32_t i, uint32_t j) const { return edges_.count({i, j}) != 0; }

    static constexpr uint32_t kReach = 64;

private:
    struct Plane {
        double x, y;
    };
    using Corners = std::array<uint32_t, 3>;

    static Plane projected(const Place& place);
    static double area(const Plane& a, const Plane& b, const Plane& c);
    bool is_delaunay(const Corners& c) const;

    std::vector<Plane> points_;
    std::vector<Corners> triangles_;  // those with a corner below kReach, counter-clockwise
    std::set<std::pair<uint32_t, uint32_t>> edges_;
};

}  // namespace lumi::twin
