// SPDX-License-Identifier: MIT
// What a mesh gets wrong.
#pragma once

#include <string>
#include <vector>

#include "lumi/baker/mesh_loss.h"
#include "mesh/survey.h"

namespace lumi::baker
{

template <class Io>
void fields(Io& io, MeshLoss& loss)
{
    io(loss.missed, loss.added, loss.displaced, loss.rough, loss.holes, loss.largest_hole);
}

MeshLoss loss_of(const SceneData& scene, const MeshTracer& tracer, Job& job, const ViewCap& cap = {});

// `asked` and `got` are triangles that can be seen; ask for no more than the scene has. Sentences for the user: what
// is wrong, and what mends it. `of_volume`: the mesh is a volume's shell.
std::vector<std::string> mesh_warnings(const MeshLoss& loss, size_t asked, size_t got, bool of_volume);

}  // namespace lumi::baker
