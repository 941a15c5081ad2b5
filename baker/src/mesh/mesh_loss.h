// SPDX-License-Identifier: MIT
// What a mesh gets wrong.
#pragma once

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

}  // namespace lumi::baker
