// SPDX-License-Identifier: MIT
// Where texels are worth most.
#pragma once

#include "lumi/baker/surface.h"
#include "mesh/patch_mesh.h"

namespace lumi::baker
{

struct DensityLight {
    const SceneData& scene;
    float times = 1;  // what its levels count
};

// Texels a radius, by patch: the more the colours of neighbouring texels differ in some light and the more often a
// patch is seen, the denser; no more texels in all than with settings.texels_per_radius everywhere. Traces some light
// paths a texel in each light.
std::vector<float> texel_densities(const std::vector<DensityLight>& lights, const PatchMesh& mesh,
                                   const SurfaceSettings& settings, const ProgressCallback& progress);

}  // namespace lumi::baker
