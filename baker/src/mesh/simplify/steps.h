// SPDX-License-Identifier: MIT
// Steps before and after the edges of a mesh are collapsed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/mesh.h"

namespace lumi::baker
{

// Closes seams between parts that lie beside each other, such as a car's bonnet and its wings.

// Vertices of borders that lie at most `reach` from a border of another part become one with the first of them that
// lies as near; triangles that have two such corners go. Without this, simplification cuts off each border for itself,
// and a seam that nobody saw gapes. A part is what shares no vertex with the rest. One whose area would change much
// by this keeps its vertices. Positions stay, used or not.
Mesh with_closed_seams(const Mesh& mesh, float reach);

// Leaves out flaps: small surfaces at edges of more than two triangles, as meshes that were scanned or made coarser
// have them by the thousand.

// The triangles without those surfaces that are smaller than `small`, in square radii, that hang at the rest by an edge
// and leave no hole in it. No body loses more than a fiftieth of its area. A body is what shares no vertex with the
// rest. `surfaces`: by triangle, the number of the one that it is of.
std::vector<Mesh::Corners> without_flaps(const Mesh& mesh, const std::vector<uint32_t>& surfaces, double small);

// Keeps what simplification would lose because it is thinner than the error elsewhere: rods, wires, spokes.

using Triangles = std::vector<Mesh::Corners>;

// Triangles that stand for others, about so many.
struct Fewer {
    Triangles triangles;
    bool rough = false;  // the shape's topology was given up
};
using MakeFewer = std::function<Fewer(const std::vector<Vec3>& positions, const Triangles&, size_t)>;

// Returns what `make_fewer` makes of all triangles. A part is what shares no vertex with the rest. Parts that lose much
// of their area there are made fewer each by itself, as long as that keeps the area, and a quarter of the triangles
// goes to them; those first that take the fewest for what they show.
Fewer fewer_with_thin_parts(const Mesh& mesh, size_t triangles, const MakeFewer& make_fewer);

}  // namespace lumi::baker
