// SPDX-License-Identifier: MIT
#include "volume/iso_surface.h"

#include <algorithm>
#include <numeric>

#include "geometry/polygon.h"
#include "volume/affine.h"
#include "volume/volume_file.h"

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

namespace
{

using Step = std::array<int32_t, 3>;

// The length of a step between voxels in the grid's world.
float length_of(const Grid& grid, const Step& step)
{
    double sum = 0;
    for (const auto& row : grid.voxel_to_world) {
        const double way = row[0] * step[0] + row[1] * step[1] + row[2] * step[2];
        sum += way * way;
    }
    return static_cast<float>(std::sqrt(sum));
}

// Light that comes along one step after the other, over the whole grid: depths from where it enters.
class Sweep
{
public:
    Sweep(const Grid& grid, const std::vector<float>& densities, const Step& step)
        : size_{static_cast<int32_t>(grid.nx), static_cast<int32_t>(grid.ny), static_cast<int32_t>(grid.nz)},
          densities_(densities),
          step_(step),
          half_(length_of(grid, step) / 2),
          back_((static_cast<ptrdiff_t>(step[2]) * size_[1] + step[1]) * size_[0] + step[0]),
          depths_(densities.size())
    {
    }

    // Lowers `least` to this light's depths.
    void run(std::vector<float>& least)
    {
        const auto at = [&](int k, size_t axis) { return step_[axis] < 0 ? size_[axis] - 1 - k : k; };
        for (int c = 0; c < size_[2]; ++c) {
            for (int b = 0; b < size_[1]; ++b) {
                const int y = at(b, 1), z = at(c, 2);
                const bool enters = leaves(y - step_[1], 1) || leaves(z - step_[2], 2);
                const ptrdiff_t row = (static_cast<ptrdiff_t>(z) * size_[1] + y) * size_[0];
                for (int a = 0; a < size_[0]; ++a) {
                    const int x = at(a, 0);
                    visit(row + x, enters || leaves(x - step_[0], 0), least);
                }
            }
        }
    }

private:
    bool leaves(int place, size_t axis) const { return place < 0 || place >= size_[axis]; }

    void visit(ptrdiff_t voxel, bool enters, std::vector<float>& least)
    {
        const auto here = static_cast<size_t>(voxel), before = static_cast<size_t>(voxel - back_);
        depths_[here] = enters ? 0 : depths_[before] + half_ * (densities_[before] + densities_[here]);
        least[here] = std::min(least[here], depths_[here]);
    }

    const Step size_;
    const std::vector<float>& densities_;
    const Step step_;
    const float half_;
    const ptrdiff_t back_;
    std::vector<float> depths_;
};

// Every so many voxels only, so that no side has more than kMostVoxels.
Grid coarser(const Grid& grid)
{
    constexpr uint32_t kMostVoxels = 112;  // a side; a mesh of some thousand triangles shows no more
    const uint32_t stride = (std::max({grid.nx, grid.ny, grid.nz}) + kMostVoxels - 1) / kMostVoxels;
    const auto left = [&](uint32_t n) { return std::max((n - 1) / stride + 1, 2u); };
    if (stride == 1 || std::min({grid.nx, grid.ny, grid.nz}) <= stride) return grid;
    Grid result;
    result.nx = left(grid.nx);
    result.ny = left(grid.ny);
    result.nz = left(grid.nz);
    result.voxel_to_world = grid.voxel_to_world;
    for (auto& row : result.voxel_to_world)
        for (size_t k = 0; k < 3; ++k) row[k] *= stride;
    for (uint32_t z = 0; z < result.nz; ++z) {
        for (uint32_t y = 0; y < result.ny; ++y) {
            const size_t row = (size_t{z} * grid.ny + y) * stride * grid.nx;  // where voxel stride·(0, y, z) is
            for (uint32_t x = 0; x < result.nx; ++x) result.values.push_back(grid.values[row + size_t{x} * stride]);
        }
    }
    return result;
}

}  // namespace

Grid optical_depths(const Volume& volume)
{
    Grid result = volume.grid;
    std::vector<float> densities;
    densities.reserve(result.values.size());
    for (const float v : volume.grid.values) densities.push_back(volume.transfer.density(v));
    std::fill(result.values.begin(), result.values.end(), std::numeric_limits<float>::max());
    for (int k = 0; k < 27; ++k) {
        const Step step = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        if (step != Step{0, 0, 0}) Sweep(result, densities, step).run(result.values);
    }
    return result;
}

Mesh opacity_surface(const Volume& volume)
{
    constexpr float kLog2 = 0.693147181f;
    return iso_surface(coarser(optical_depths(volume)), kLog2);
}

}  // namespace lumi::baker
