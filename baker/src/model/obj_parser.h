// SPDX-License-Identifier: MIT
// The faces of an OBJ text as plain data: tinyobjloader behind a wall.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"

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

}  // namespace lumi::baker
