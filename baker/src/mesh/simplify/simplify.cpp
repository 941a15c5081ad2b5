// SPDX-License-Identifier: MIT
// The one file that sees meshoptimizer.
#include "mesh/simplify/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/components.h"
#include "mesh/simplify/steps.h"

namespace lumi::baker
{
namespace
{

constexpr double kTolerated = 1.25;  // where more times the triangles asked for remain, topology is given up
constexpr float kMaxError = 0.1f;    // as a share of the extent: a stalled search would swallow whole objects
constexpr float kMaxRoughError = 1;

using Indices = std::vector<uint32_t>;

Indices indices_of(const Triangles& triangles)
{
    Indices indices;
    for (const Mesh::Corners& c : triangles) indices.insert(indices.end(), c.begin(), c.end());
    return indices;
}

template <class Simplifier>
Indices reduced(const Indices& indices, const Simplifier& simplify)
{
    Indices out(indices.size());
    out.resize(simplify(out.data()));
    return out;
}

Triangles triangles_of(const Indices& indices)
{
    Triangles triangles;
    for (size_t k = 0; k + 2 < indices.size(); k += 3)
        triangles.push_back({indices[k], indices[k + 1], indices[k + 2]});
    return triangles;
}

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

Indices simplified_to(size_t triangles, const Indices& indices, const std::vector<Vec3>& positions)
{
    return reduced(
        indices,
        [&](uint32_t* out) {
            return meshopt_simplify(out, indices.data(), indices.size(), &positions[0].x, positions.size(),
                                    sizeof(Vec3), 3 * triangles, kMaxError, 0, nullptr);
        });
}

// Stalled by what it must not collapse.
bool is_stalled(const Indices& indices, size_t triangles)
{
    return static_cast<double>(indices.size()) > 3 * kTolerated * static_cast<double>(triangles);
}

// A side of a triangle, by its corners: 3k + i is corner i of triangle k.
struct Side {
    uint32_t from, to;
};

// The sides that an edge has; what is here is two of them.
struct Edge {
    Side first, second;
    uint32_t uses = 0;
};

using Edges = std::unordered_map<uint64_t, Edge>;

Edges edges_of(const Indices& indices)
{
    Edges edges;
    for (uint32_t k = 0; k < indices.size(); k += 3) {
        for (uint32_t i = 0; i < 3; ++i) {
            const Side side = {k + i, k + (i + 1) % 3};
            Edge& edge = edges[edge_key(indices[side.from], indices[side.to])];
            (edge.uses++ == 0 ? edge.first : edge.second) = side;
        }
    }
    return edges;
}

// The corners of triangles around a vertex, joined across edges that these share as surfaces do: two triangles, in
// opposite directions.
DisjointSets corner_sets(const Indices& indices)
{
    DisjointSets sets(indices.size());
    for (const auto& [key, edge] : edges_of(indices)) {
        const bool is_one_surface = edge.uses == 2 && indices[edge.first.from] == indices[edge.second.to];
        if (!is_one_surface) continue;
        sets.join(edge.first.from, edge.second.to);
        sets.join(edge.first.to, edge.second.from);
    }
    return sets;
}

// Surfaces that meet in an edge of more than two triangles, or whose windings differ, are parted there: each gets
// vertices of its own, beside each other by less than shows. Only so may the simplifier collapse them.
struct Parted {
    std::vector<Vec3> positions;
    Indices indices;
    Indices originals;  // by vertex
};

Parted parted(const std::vector<Vec3>& positions, const Indices& indices)
{
    constexpr float kBeside = 1e-6f;  // radii
    DisjointSets sets = corner_sets(indices);
    std::unordered_map<uint32_t, uint32_t> numbers;
    std::vector<uint32_t> copies(positions.size(), 0);
    Parted result;
    for (uint32_t corner = 0; corner < indices.size(); ++corner) {
        const auto [number, is_new] =
            numbers.try_emplace(sets.root(corner), static_cast<uint32_t>(result.positions.size()));
        if (is_new) {
            const float by = kBeside * static_cast<float>(copies[indices[corner]]++);
            result.positions.push_back(positions[indices[corner]] + Vec3{by, by, by});
            result.originals.push_back(indices[corner]);
        }
        result.indices.push_back(number->second);
    }
    return result;
}

// A triangle between two copies of a vertex has no area once they are one again.
Indices simplified_in_parts(size_t triangles, const std::vector<Vec3>& positions, const Indices& indices)
{
    const Parted parts = parted(positions, indices);
    const Indices few = simplified_to(triangles, parts.indices, parts.positions);
    Indices result;
    for (size_t k = 0; k + 2 < few.size(); k += 3) {
        const Mesh::Corners c = {parts.originals[few[k]], parts.originals[few[k + 1]], parts.originals[few[k + 2]]};
        if (!is_degenerate(c)) result.insert(result.end(), c.begin(), c.end());
    }
    return result;
}

Fewer fewer_of(const std::vector<Vec3>& positions, const Triangles& whole, size_t triangles)
{
    if (whole.size() <= triangles) return {whole, false};
    const Indices all = indices_of(whole);
    Indices indices = simplified_to(triangles, all, positions);
    if (is_stalled(indices, triangles)) indices = simplified_in_parts(triangles, positions, all);
    const bool rough = is_stalled(indices, triangles);
    if (rough) {  // the rougher one leaves fewer than asked for
        indices = reduced(
            indices,
            [&](uint32_t* out) {
                return meshopt_simplifySloppy(out, indices.data(), indices.size(), &positions[0].x, positions.size(),
                                              sizeof(Vec3), 3 * triangles, kMaxRoughError, nullptr);
            });
    }
    return {triangles_of(indices), rough};
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

// Without flaps far smaller than a triangle to come. None could become fewer than one triangle, and nothing could be
// made coarser across them, so the rest would pay.
Mesh without_small_flaps(Mesh mesh, size_t triangles)
{
    constexpr double kSmall = 0.05;  // of the mean triangle to come
    Parted parts = parted(mesh.positions, indices_of(mesh.corners));
    Mesh apart;
    apart.positions = std::move(parts.positions);
    apart.corners = triangles_of(parts.indices);
    Components components(apart);
    std::vector<uint32_t> surfaces;
    for (const Mesh::Corners& c : apart.corners) surfaces.push_back(components.of(c));
    mesh.corners = without_flaps(mesh, surfaces, kSmall * mean_area(mesh, triangles));
    return mesh;
}

}  // namespace

Simplified simplified(const Mesh& mesh, size_t triangles)
{
    if (mesh.triangle_count() <= triangles) return {compact(mesh.positions, mesh.corners), false};
    const Mesh whole = without_small_flaps(with_closed_seams(mesh, seam_of(mesh, triangles)), triangles);
    const Fewer fewer = fewer_with_thin_parts(whole, triangles, fewer_of);
    return {compact(mesh.positions, fewer.triangles), fewer.rough};
}

}  // namespace lumi::baker
