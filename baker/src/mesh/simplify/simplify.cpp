// SPDX-License-Identifier: MIT
#include "mesh/simplify/simplify.h"

#include <algorithm>
#include <cmath>

#include "mesh/simplify/steps.h"

namespace lumi::baker
{
namespace
{

// Only the vertices that the triangles use.
Mesh compact(const std::vector<Vec3>& positions, const Triangles& triangles)
{
    Mesh mesh;
    std::vector<int64_t> number(positions.size(), -1);
    const auto corner = [&](uint32_t old) {
        if (number[old] < 0) {
            number[old] = static_cast<int64_t>(mesh.positions.size());
            mesh.positions.push_back(positions[old]);
        }
        return static_cast<uint32_t>(number[old]);
    };
    for (const Mesh::Corners& c : triangles) mesh.corners.push_back({corner(c[0]), corner(c[1]), corner(c[2])});
    return mesh;
}

// The mean area of a triangle, where the mesh has so many.
double mean_area(const Mesh& mesh, size_t triangles)
{
    double area = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) area += static_cast<double>(mesh.area(k));
    return area / static_cast<double>(triangles);
}

// Narrower gaps are closed, since edges will be longer: a tenth of the mean one, and a pixel at 240 x 240 at most.
float seam_of(const Mesh& mesh, size_t triangles)
{
    constexpr double kShareOfEdge = 0.1, kMost = 1.0 / 120;
    const double edge = std::sqrt(4 / std::sqrt(3.0) * mean_area(mesh, triangles));
    return static_cast<float>(std::min(kMost, kShareOfEdge * edge));
}

}  // namespace

Mesh simplified(const Mesh& mesh, size_t triangles, const std::vector<float>& openness)
{
    if (mesh.triangle_count() <= triangles) return compact(mesh.positions, mesh.corners);
    const Mesh whole = with_closed_seams(mesh, seam_of(mesh, triangles));
    return compact(mesh.positions, fewer_with_thin_parts(whole, openness, triangles, with_edges_collapsed));
}

}  // namespace lumi::baker
