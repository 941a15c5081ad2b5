// SPDX-License-Identifier: MIT
// Vertices of models: places in double precision, and colours, which become a picture, since the path tracer reads
// colours from pictures only.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"
#include "image/texture.h"
#include "math/vec3.h"

namespace lumi::baker
{

// Maps and scans lie millions of metres from their origin. Squares and differences stay exact enough in binary64 and
// finite in binary32.
inline constexpr double kMaxCoordinate = 1e15;

using Point = std::array<double, 3>;

// In binary32, and what to add to them.
struct CentredPositions {
    std::vector<Vec3> positions;
    Point origin = {0, 0, 0};
};

// The origin stays that of the file unless the points lie so far from it that binary32 loses their shape.
CentredPositions centred(const std::vector<Point>& points);

// These are linear colours at the corners of a triangle.
using CornerColours = std::array<Rgb, 3>;

// A picture with a block of pixels for each triangle from `first` on, and texture coordinates of these triangles into
// it. Bilinear filtering of a block of 2 by 2 pixels is linear over the triangle, so that the picture shows what a
// rasteriser interpolates. Where that would take a colour outside of 0 to 1, blocks have 4 by 4 pixels, and errors stay
// below 0.09. Colours are kept as 8 bits of sRGB. `colours` has an entry for each of these triangles; at least one.
// Throws SceneError where they are too many for a picture.
Texture picture_of_corners(Mesh& mesh, size_t first, const std::vector<CornerColours>& colours);

}  // namespace lumi::baker
