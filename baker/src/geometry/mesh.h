// SPDX-License-Identifier: MIT
// Keeps triangles in the frame of the unit sphere, as indices into shared arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/vec3.h"

namespace lumi::baker
{

inline constexpr int32_t kNoIndex = -1;

struct Mesh {
    using Corners = std::array<uint32_t, 3>;
    using OptionalCorners = std::array<int32_t, 3>;  // kNoIndex where the file gives none

    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  // unit length
    std::vector<Vec2> uvs;
    std::vector<Vec2> second_uvs;  // another place for each of the first so many of `uvs`
    // These have one entry a triangle:
    std::vector<Corners> corners;          // into positions
    std::vector<OptionalCorners> shading;  // into normals: all three or none
    std::vector<OptionalCorners> mapping;  // into uvs: all three or none
    std::vector<uint32_t> materials;

    size_t triangle_count() const { return corners.size(); }
    const Vec3& position(size_t triangle, size_t corner) const { return positions[corners[triangle][corner]]; }

    // Twice the area long, by the right-hand rule.
    Vec3 area_vector(size_t triangle) const
    {
        const Vec3& a = position(triangle, 0);
        return cross(position(triangle, 1) - a, position(triangle, 2) - a);
    }
    float area(size_t triangle) const { return 0.5f * length(area_vector(triangle)); }
};

// The triangles that are wanted, with all of the mesh's positions.
template <class Wanted>
Mesh part_of(const Mesh& mesh, const Wanted& wanted)
{
    Mesh part;
    part.positions = mesh.positions;
    part.normals = mesh.normals;
    part.uvs = mesh.uvs;
    part.second_uvs = mesh.second_uvs;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!wanted(t)) continue;
        part.corners.push_back(mesh.corners[t]);
        part.shading.push_back(mesh.shading[t]);
        part.mapping.push_back(mesh.mapping[t]);
        part.materials.push_back(mesh.materials[t]);
    }
    return part;
}

// Whether two corners are one vertex: then there is no area.
inline bool is_degenerate(const Mesh::Corners& c)
{
    return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

// An edge has the same number whichever way it runs: the lower vertex stands above the higher one.
inline uint64_t edge_key(uint32_t a, uint32_t b)
{
    return uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

// Positions and corners, for files of a bake (byte_stream.h).
template <class Io>
void fields(Io& io, Mesh& mesh)
{
    io(mesh.positions, mesh.corners);
    for (const Mesh::Corners& triangle : mesh.corners)
        for (const uint32_t corner : triangle) io.require(corner < mesh.positions.size());
}

}  // namespace lumi::baker
