// SPDX-License-Identifier: MIT
// Where texels are worth most.
#pragma once

#include "lumi/baker/surface.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// Texels a radius, by patch: the more the colours of neighbouring texels differ and the more often a patch is seen, the
// denser; no more texels in all than with settings.texels_per_radius everywhere. Traces some light paths a texel.
std::vector<float> texel_densities(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings,
                                   const ProgressCallback& progress);

}  // namespace lumi::baker
