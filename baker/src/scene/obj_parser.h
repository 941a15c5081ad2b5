// SPDX-License-Identifier: MIT
// The faces of an OBJ text and the materials of an MTL text as plain data: tinyobjloader behind a wall.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "scene/materials.h"

namespace lumi::baker
{

struct ObjCorner {
    int32_t position, normal, uv;  // kNoIndex where the file gives none
};

struct ObjFace {
    uint32_t first, count;  // corners
    int32_t material;       // place in ObjText::materials, or kNoIndex
    uint32_t smoothing;     // group, 0 = none
};

struct ObjContent {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> uvs;
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;  // in file order
};

// `text` comes from prepare_obj, with `material_count` materials. Throws SceneError, with `file` in its message.
ObjContent parse_obj(const std::string& file, const std::string& text, size_t material_count);

// `text` comes from prepare_mtl; lines and files of the result are still to be filled in.
std::vector<MtlMaterial> parse_mtl(const std::string& text);

}  // namespace lumi::baker
