// SPDX-License-Identifier: MIT
// Meshes made in memory, and what tests ask of any mesh.
#pragma once

#include <map>

#include "geometry/mesh.h"
#include "math/warp.h"

namespace lumi::baker::testing
{

// A sheet of w × h squares of that side in the plane z = 0, two triangles each, counter-clockwise seen from above.
inline Mesh sheet(uint32_t w, uint32_t h, float side)
{
    Mesh mesh;
    for (uint32_t y = 0; y <= h; ++y)
        for (uint32_t x = 0; x <= w; ++x)
            mesh.positions.push_back({static_cast<float>(x) * side, static_cast<float>(y) * side, 0});
    for (uint32_t y = 0; y < h; ++y) {
        for (uint32_t x = 0; x < w; ++x) {
            const uint32_t a = y * (w + 1) + x, b = a + 1, c = a + w + 1, d = c + 1;
            mesh.corners.push_back({a, b, c});
            mesh.corners.push_back({d, c, b});
        }
    }
    return mesh;
}

// A cube around the origin, wound outwards, corners shared.
inline Mesh cube(float half_side)
{
    Mesh mesh;
    for (int k = 0; k < 8; ++k) {
        const auto at = [&](int bit) { return (k >> bit & 1) != 0 ? half_side : -half_side; };
        mesh.positions.push_back({at(0), at(1), at(2)});
    }
    mesh.corners = {{0, 2, 1}, {3, 1, 2}, {4, 5, 6}, {7, 6, 5}, {0, 1, 4}, {5, 4, 1},
                    {2, 6, 3}, {7, 3, 6}, {0, 4, 2}, {6, 2, 4}, {1, 3, 5}, {7, 5, 3}};
    return mesh;
}

inline double whole_area(const Mesh& mesh)
{
    double sum = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) sum += static_cast<double>(mesh.area(k));
    return sum;
}

inline float longest_edge(const Mesh& mesh)
{
    float longest = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k)
        for (size_t i = 0; i < 3; ++i)
            longest = std::max(longest, length(mesh.position(k, i) - mesh.position(k, (i + 1) % 3)));
    return longest;
}

// Edges that one triangle has alone, or that two triangles run along in the same direction.
inline uint32_t open_edges(const Mesh& mesh)
{
    std::map<std::pair<uint32_t, uint32_t>, int> balance;
    for (const Mesh::Corners& c : mesh.corners) {
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t a = c[i], b = c[(i + 1) % 3];
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    uint32_t open = 0;
    for (const auto& [edge, sum] : balance) open += sum != 0 ? 1u : 0u;
    return open;
}

}  // namespace lumi::baker::testing
