// SPDX-License-Identifier: MIT
#include "volume/iso_surface.h"

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

}  // namespace lumi::baker
