// SPDX-License-Identifier: MIT
// Decodes the contents of a surface file without core's reader.
#pragma once

#include <vector>

#include "lumi/twin/geometry.h"
#include "lumi/twin/picture.h"

namespace lumi::twin
{

struct SurfaceTriangle {
    uint32_t vertices[3];
    uint32_t begin, n, m;  // where its rectangle of texels begins, and the rectangle's size
    bool second;           // texture coordinates run backwards
};

// The difference that a view table adds, at each node.
struct SurfaceView {
    int32_t turn[3];
    std::vector<Colour> nodes;
};

struct SurfaceFile {
    explicit SurfaceFile(const uint8_t* file);

    std::vector<Vec3> positions;
    std::vector<SurfaceTriangle> triangles;
    std::vector<Colour> texels;
    std::vector<SurfaceView> views;  // tables of the first vertices, in order
};

}  // namespace lumi::twin
