// SPDX-License-Identifier: MIT
// The directions on a triangle along which its texture coordinates grow.
#pragma once

#include "material/texture_slot.h"

namespace lumi::baker
{

struct Tangents {
    Vec3 u;            // of any length, in the triangle's plane
    float handedness;  // -1 where the picture is mirrored: v grows against cross(normal, u)
};

// Nothing where the triangle has no texture coordinates or they do not span an area.
inline std::optional<Tangents> tangents_of(const Mesh& mesh, uint32_t triangle)
{
    const std::optional<CornerUvs> uvs = corner_uvs(mesh, triangle);
    if (!uvs) return std::nullopt;
    const auto& [p, q, r] = *uvs;
    const float area = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
    if (area == 0) return std::nullopt;
    const Vec3 e = mesh.position(triangle, 1) - mesh.position(triangle, 0);
    const Vec3 f = mesh.position(triangle, 2) - mesh.position(triangle, 0);
    const float sign = area < 0 ? -1.0f : 1.0f;
    return Tangents{(e * (r.y - p.y) - f * (q.y - p.y)) * sign, sign};
}

}  // namespace lumi::baker
