// SPDX-License-Identifier: MIT
// Reads the words of an OBJ text in one pass.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "model/losses.h"
#include "model/positions.h"

namespace lumi::baker
{

struct ObjCorner {
    int32_t position, normal, uv;  // kNoIndex where the file gives none
};

struct ObjFace {
    uint32_t first, count;  // corners: three or more
    int32_t material;       // place in ObjContent::materials, or kNoIndex
    uint32_t smoothing;     // group, 0 = none
    uint32_t line;
};

// A name as it is written, with blanks, and where it stands first.
struct ObjName {
    std::string name;
    uint32_t line;
};

// Faces below a line 'o' or 'g', up to the next one; groups also end where an object begins.
struct ObjPart {
    std::string name;
    size_t first = 0, end = 0;
};

struct ObjContent {
    std::vector<Point> positions;
    std::vector<Rgb> colours;  // as a display shows them, 0 to 1; empty, or one a position
    std::vector<Vec3> normals;
    std::vector<Vec2> uvs;
    std::vector<ObjCorner> corners;  // in range
    std::vector<ObjFace> faces;      // in the file's order
    std::vector<ObjName> libraries, materials;
    std::vector<ObjPart> parts;
};

// Faces may come before what they use. `file` only serves messages. Throws SceneError, also where there is no face.
ObjContent scan_obj(const std::string& file, std::string_view text, Losses& losses);

}  // namespace lumi::baker
