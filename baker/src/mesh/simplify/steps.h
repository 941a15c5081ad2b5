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

using Triangles = std::vector<Mesh::Corners>;

struct Vertices {
    std::vector<Vec3> positions;
    std::vector<float> openness;  // how much of the surface there is seen, 0 .. 1; empty: all alike
};

// Collapses edges one after the other, those first whose loss shows least: by squares of distances to the planes of the
// triangles that a vertex stands for, weighed by their area, by their openness and by how many eyes see an outline
// there. Topology does not count: surfaces may grow together, and what is too small to show may vanish. About so many
// triangles remain, more where each collapse would turn some triangle over.
Triangles with_edges_collapsed(const Vertices& vertices, const Triangles& triangles, size_t wanted);

// Keeps what simplification would lose because it is thinner than the error elsewhere: rods, wires, spokes.

using MakeFewer = std::function<Triangles(const Vertices&, const Triangles&, size_t)>;

// Returns what `make_fewer` makes of all triangles. A part is what shares no vertex with the rest. Parts that lose much
// of their area there are made fewer each by itself, as long as that keeps the area, and a quarter of the triangles
// goes to them; those first that take the fewest for what they show.
Triangles fewer_with_thin_parts(const Mesh& mesh, const std::vector<float>& openness, size_t triangles,
                                const MakeFewer& make_fewer);

}  // namespace lumi::baker
