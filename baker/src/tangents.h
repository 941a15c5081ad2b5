// SPDX-License-Identifier: MIT
// The directions on a triangle along which its texture coordinates grow.
#pragma once

#include <optional>

#include "mesh.h"

namespace lumi::baker
{

struct Tangents {
    Vec3 u;            // of any length, in the triangle's plane
    float handedness;  // -1 where the picture is mirrored: v grows against cross(normal, u)
};

// Nothing where the triangle has no texture coordinates or they do not span an area.
inline std::optional<Tangents> tangents_of(const Mesh& mesh, uint32_t triangle)
{
    const Mesh::OptionalCorners& c = mesh.mapping[triangle];
    if (c[0] == kNoIndex) {
        return std::nullopt;
    }
    const Vec2& p = mesh.uvs[static_cast<size_t>(c[0])];
    const Vec2& q = mesh.uvs[static_cast<size_t>(c[1])];
    const Vec2& r = mesh.uvs[static_cast<size_t>(c[2])];
    const float area = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
    if (area == 0) {
        return std::nullopt;
    }
    const Vec3 e = mesh.position(triangle, 1) - mesh.position(triangle, 0);
    const Vec3 f = mesh.position(triangle, 2) - mesh.position(triangle, 0);
    const float sign = area < 0 ? -1.0f : 1.0f;
    return Tangents{(e * (r.y - p.y) - f * (q.y - p.y)) * sign, sign};
}

}  // namespace lumi::baker
