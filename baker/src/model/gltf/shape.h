// SPDX-License-Identifier: MIT
// Reads the triangles of a glTF primitive.
#pragma once

#include "model/gltf/model.h"
#include "model/losses.h"

namespace lumi::baker
{

using GltfTriangle = std::array<uint32_t, 3>;

struct GltfShape {
    std::vector<Vec3> positions;        // that triangles use, in the file's order
    std::vector<Vec3> normals;          // they have any length; empty, or one a position, as the next two
    std::vector<Vec2> uvs, second_uvs;  // as in the file, v downwards
    std::vector<Rgb> colours;
    std::vector<GltfTriangle> triangles;  // in range
    bool is_bent = false;                 // by a skin: positions are those of the scene, whatever the node's place
};

// Takes up to two sets of texture coordinates, or set 0. Without triangles where the primitive is points or lines.
// `used` gets the rows of accessors that the vertices come from. Throws SceneError where numbers are damaged.
GltfShape shape_of(const GltfModel& model, const GltfPrimitive& primitive, const std::vector<int32_t>& uv_sets,
                   Losses& losses, std::vector<uint32_t>& used);

// The most replacements of sparse accessors that all primitives of a file may read, each of them anew.
inline constexpr size_t kMostReplacements = 100'000'000;
// How many of them this one reads; a damaged file's count is cut off just above.
size_t replacements_of(const GltfModel& model, const GltfPrimitive& primitive);

}  // namespace lumi::baker
