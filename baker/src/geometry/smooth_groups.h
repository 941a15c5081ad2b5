// SPDX-License-Identifier: MIT
// Gives each side of a crease vertices of its own.
#pragma once

#include "geometry/mesh.h"

namespace lumi::baker
{

// Triangles that share an edge and turn less than `crease_cosine` there share its vertices; other triangles at the
// same place get copies, and so does each triangle at an edge of more than 64. Only positions and corners count; the
// result's normals are one for each position: the mean of the triangles around, weighted by their angles.
Mesh with_creases(const Mesh& mesh, float crease_cosine);

}  // namespace lumi::baker
