// SPDX-License-Identifier: MIT
// Surface bakes that take a fraction of a second.
#pragma once

#include <string>

#include "lumi/baker/surface.h"
#include "support/bake_scenes.h"

namespace lumi::baker::testing
{

inline SurfaceSettings tiny_surface()
{
    SurfaceSettings s;
    s.triangles = 60;
    s.longest_edge = 0.6f;
    s.texels_per_radius = 6;
    s.paths_per_texel = 20;
    s.threads = 1;
    return s;
}

// With nothing left to choose.
inline SurfacePlan planned(const Scene& scene, const SurfaceSettings& settings)
{
    return plan_surface(scene, settings, {UINT32_MAX, std::nullopt, false, false, false});
}

inline std::string baked(const Scene& scene, const SurfaceSettings& settings)
{
    const SurfaceBake bake = surface_field(scene, {settings});
    return {bake.file.begin(), bake.file.end()};
}

}  // namespace lumi::baker::testing
