// SPDX-License-Identifier: MIT
// Colours at vertices as a picture: the path tracer reads colours from pictures only.
#pragma once

#include <array>

#include "geometry/mesh.h"
#include "image/texture.h"

namespace lumi::baker
{

// Colours, linear, at the corners of a triangle.
using CornerColours = std::array<Rgb, 3>;

// A picture with a block of pixels for each triangle from `first` on, and texture coordinates of these triangles into
// it. Bilinear filtering of a block of 2 by 2 pixels is linear over the triangle, so that the picture shows what a
// rasteriser interpolates. Where that would take a colour outside of 0 to 1, blocks have 4 by 4 pixels, and errors stay
// below 0.09. Colours are kept as 8 bits of sRGB. `colours` has an entry for each of these triangles; at least one.
// Throws SceneError where they are too many for a picture.
Texture picture_of_corners(Mesh& mesh, size_t first, const std::vector<CornerColours>& colours);

}  // namespace lumi::baker
