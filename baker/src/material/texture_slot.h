// SPDX-License-Identifier: MIT
// Reads a material's picture at a place on a triangle.
#pragma once

#include <optional>

#include "geometry/mesh.h"
#include "image/texture.h"
#include "material/material.h"

namespace lumi::baker
{

struct CornerUvs {
    Vec2 p, q, r;
};

// The coordinates that the slot takes. Nothing on triangles without them.
inline std::optional<CornerUvs> corner_uvs(const Mesh& mesh, const TextureSlot& slot, uint32_t triangle)
{
    const Mesh::OptionalCorners& c = mesh.mapping[triangle];
    const std::vector<Vec2>& uvs = slot.takes_second_uvs ? mesh.second_uvs : mesh.uvs;
    const auto is_there = [&](int32_t k) { return k != kNoIndex && static_cast<size_t>(k) < uvs.size(); };
    if (!is_there(c[0]) || !is_there(c[1]) || !is_there(c[2])) return std::nullopt;
    return CornerUvs{uvs[static_cast<size_t>(c[0])], uvs[static_cast<size_t>(c[1])], uvs[static_cast<size_t>(c[2])]};
}

// Weights of the second and third corner give the place. Nothing on triangles without texture coordinates.
inline std::optional<Vec2> uv_at(const Mesh& mesh, const TextureSlot& slot, uint32_t triangle, const Vec2& barycentric)
{
    const std::optional<CornerUvs> uvs = corner_uvs(mesh, slot, triangle);
    if (!uvs) return std::nullopt;
    const auto& [p, q, r] = *uvs;
    const float w = 1 - barycentric.x - barycentric.y;
    return Vec2{w * p.x + barycentric.x * q.x + barycentric.y * r.x,
                w * p.y + barycentric.x * q.y + barycentric.y * r.y};
}

// Returns white without a picture or texture coordinates.
inline Rgb slot_colour(const Mesh& mesh, const std::vector<Texture>& textures, const TextureSlot& slot,
                       uint32_t triangle, const Vec2& barycentric)
{
    if (!slot.used()) return grey(1);
    const std::optional<Vec2> uv = uv_at(mesh, slot, triangle, barycentric);
    if (!uv) return grey(1);
    return textures[static_cast<size_t>(slot.texture)].at(slot.place(*uv), slot.wrap);
}

}  // namespace lumi::baker
