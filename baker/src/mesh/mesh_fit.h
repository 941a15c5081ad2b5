// SPDX-License-Identifier: MIT
// Moves the vertices of a mesh onto the depth that rays find in the scene, and its outlines onto the scene's.
#pragma once

#include "mesh/survey.h"

namespace lumi::baker
{

// One round: the displacements of all vertices that bring the hits of `survey` onto the scene in the least-squares
// sense, distances along the triangles' normals, kept smooth over the mesh; and points of the outlines that are seen
// from far behind the survey's origins, distances in the image. Rays whose depths differ by more than kMaxDepthError
// say nothing, so by hits alone a mesh grows at its outlines: those of what sticks out are left out. Vertices stay
// whose triangles would turn far from where `upright` has them: the mesh before the first round.
Mesh fitted(const Mesh& mesh, const Mesh& upright, Faces faces, const Survey& survey, Job& job);

// As many rounds as it takes.
Mesh fitted_in_rounds(const SceneData& scene, Mesh mesh, Faces faces, Job& job, const ViewCap& cap = {});

}  // namespace lumi::baker
