// SPDX-License-Identifier: MIT
// The pattern of points around a pole, the same for every lattice, and its Delaunay triangles by brute force.
#pragma once

#include <array>
#include <set>
#include <vector>

#include "cells.h"
#include "lumi/twin/weights.h"

namespace lumi::twin
{

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
