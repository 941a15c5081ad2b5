// SPDX-License-Identifier: MIT
#include "volume/iso_surface.h"

#include <algorithm>
#include <numeric>

#include "geometry/polygon.h"
#include "volume/affine.h"
#include "volume/openvdb.h"

namespace lumi::baker
{
namespace
{

class IsoMeshBuilder
{
public:
    explicit IsoMeshBuilder(bool turned) : turned_(turned) {}

    void add_point(const std::array<double, 3>& p)
    {
        mesh_.positions.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }

    // Leaves out what has no area.
    void add_triangle(uint32_t a, uint32_t b, uint32_t c)
    {
        const std::vector<Vec3>& p = mesh_.positions;
        if (has_no_area(p[a], p[b], p[c])) return;
        constexpr Mesh::OptionalCorners kNone = {kNoIndex, kNoIndex, kNoIndex};
        mesh_.corners.push_back(turned_ ? Mesh::Corners{a, c, b} : Mesh::Corners{a, b, c});
        mesh_.shading.push_back(kNone);
        mesh_.mapping.push_back(kNone);
        mesh_.materials.push_back(0);
    }

    // Along the shorter diagonal.
    void add_quad(const std::array<uint32_t, 4>& q)
    {
        const std::vector<Vec3>& p = mesh_.positions;
        const uint32_t first = length(p[q[2]] - p[q[0]]) <= length(p[q[3]] - p[q[1]]) ? 0 : 1;
        add_triangle(q[first], q[first + 1], q[first + 2]);
        add_triangle(q[first], q[first + 2], q[(first + 3) % 4]);
    }

    Mesh take() { return std::move(mesh_); }

private:
    bool turned_;
    Mesh mesh_;
};

// Sets of vertices that are connected, each named by one of them.
class Sets
{
public:
    explicit Sets(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), uint32_t{0}); }

    uint32_t name_of(uint32_t vertex)
    {
        while (parents_[vertex] != vertex) {
            parents_[vertex] = parents_[parents_[vertex]];
            vertex = parents_[vertex];
        }
        return vertex;
    }
    void connect(uint32_t a, uint32_t b) { parents_[name_of(a)] = name_of(b); }

private:
    std::vector<uint32_t> parents_;
};

std::vector<bool> kept_triangles(const Mesh& mesh, double least)
{
    Sets sets(mesh.positions.size());
    for (const Mesh::Corners& c : mesh.corners) {
        sets.connect(c[0], c[1]);
        sets.connect(c[0], c[2]);
    }
    std::vector<double> areas(mesh.positions.size(), 0);
    for (size_t t = 0; t < mesh.triangle_count(); ++t)
        areas[sets.name_of(mesh.corners[t][0])] += static_cast<double>(mesh.area(t));
    const double largest = *std::max_element(areas.begin(), areas.end());
    std::vector<bool> kept(mesh.triangle_count());
    for (size_t t = 0; t < kept.size(); ++t) kept[t] = areas[sets.name_of(mesh.corners[t][0])] >= least * largest;
    return kept;
}

// Leaves out positions that no triangle uses.
void compact(Mesh& mesh)
{
    constexpr uint32_t kUnused = ~uint32_t{0};
    std::vector<uint32_t> places(mesh.positions.size(), kUnused);
    std::vector<Vec3> positions;
    for (Mesh::Corners& corners : mesh.corners) {
        for (uint32_t& c : corners) {
            if (places[c] == kUnused) {
                places[c] = static_cast<uint32_t>(positions.size());
                positions.push_back(mesh.positions[c]);
            }
            c = places[c];
        }
    }
    mesh.positions = std::move(positions);
}

template <class T>
void keep(std::vector<T>& list, const std::vector<bool>& kept)
{
    size_t count = 0;
    for (size_t k = 0; k < kept.size(); ++k)
        if (kept[k]) list[count++] = list[k];
    list.resize(count);
}

}  // namespace

Mesh iso_surface(const Grid& grid, float value)
{
    const Polygons polygons = dual_contour(grid, value);
    // Its polygons face away from what is below the value; ours face away from what is above. A mirrored grid turns
    // them once more.
    IsoMeshBuilder builder(determinant(grid.voxel_to_world) > 0);
    for (const auto& [x, y, z] : polygons.points) {
        builder.add_point(
            point_of(grid.voxel_to_world, static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)));
    }
    for (const auto& [a, b, c] : polygons.triangles) builder.add_triangle(a, b, c);
    for (const std::array<uint32_t, 4>& q : polygons.quads) builder.add_quad(q);
    return builder.take();
}

void add_smooth_normals(Mesh& mesh)
{
    mesh.normals.assign(mesh.positions.size(), Vec3{});
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t corner = mesh.corners[t][k];
            mesh.normals[corner] = mesh.normals[corner] + mesh.area_vector(t);
            mesh.shading[t][k] = static_cast<int32_t>(corner);
        }
    }
    for (Vec3& n : mesh.normals) {
        const float size = length(n);
        n = size > 0 ? n / size : Vec3{};
    }
}

void keep_large_pieces(Mesh& mesh, double least)
{
    if (mesh.corners.empty()) return;
    const std::vector<bool> kept = kept_triangles(mesh, least);
    keep(mesh.corners, kept);
    keep(mesh.shading, kept);
    keep(mesh.mapping, kept);
    keep(mesh.materials, kept);
    compact(mesh);
}

}  // namespace lumi::baker
