// SPDX-License-Identifier: MIT
// Reads OBJ and MTL texts by tinyobjloader, behind a wall.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"
#include "model/mtl_reader.h"
#include "model/obj_lines.h"
#include "model/vertices.h"

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
    std::vector<ObjFace> faces;      // in the file's order; at least one
    std::vector<ObjName> libraries, materials;
    std::vector<ObjPart> parts;
};

// Faces may come before what they use. `file` only serves messages. Throws SceneError, also where there is no face.
ObjContent read_obj_text(const std::string& file, std::string_view text, Losses& losses);

// Gives the numbers and maps that `material` has the values that `text` states. It has only sound lines, of one
// material.
void read_mtl_text(const std::string& text, MtlMaterial& material);

// Appends a blank and a number, which the package then reads right: `word`, which stands for `value`, or another word.
void append_number(std::string& text, std::string_view word, double value);

}  // namespace lumi::baker
