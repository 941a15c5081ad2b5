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
    io(loss.missed, loss.missed_see_through, loss.added, loss.displaced, loss.thin, loss.rough, loss.holes,
       loss.largest_hole);
}

// `see_through`: what else is there, wherever a ray meets it.
MeshLoss loss_of(const SceneData& scene, const MeshTracer& tracer, Job& job, const ViewCap& cap = {},
                 const MeshTracer* see_through = nullptr);

// Triangles of a mesh that can be seen. Ask for no more than the scene has.
struct MeshCount {
    size_t asked, got;
    bool all = false;  // the scene has no more
};

// `of_volume`: the mesh is a volume's shell.
std::vector<MeshWarning> mesh_warnings(const MeshLoss& loss, const MeshCount& triangles, bool of_volume);

}  // namespace lumi::baker
