// SPDX-License-Identifier: MIT
// Keeps what simplification would lose because it is thinner than the error elsewhere: rods, wires, spokes.
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh.h"

namespace lumi::baker
{

using Triangles = std::vector<Mesh::Corners>;

// Triangles that stand for others, about so many.
struct Fewer {
    Triangles triangles;
    bool rough = false;  // the shape's topology was given up
};
using MakeFewer = std::function<Fewer(const std::vector<Vec3>& positions, const Triangles&, size_t)>;

// What `make_fewer` makes of all triangles. A part is what shares no vertex with the rest. Parts that lose much of
// their area there are made fewer each by itself, as long as that keeps the area, and a quarter of the triangles goes
// to them; those first that take the fewest for what they show.
Fewer fewer_with_thin_parts(const Mesh& mesh, size_t triangles, const MakeFewer& make_fewer);

}  // namespace lumi::baker
