// SPDX-License-Identifier: MIT
// Guided bakes that take milliseconds.
#pragma once

#include "lumi/baker/guided.h"
#include "support/bake_scenes.h"

namespace lumi::baker::testing
{

inline GuidedSettings tiny_guided()
{
    GuidedSettings s;
    s.origins = 64;
    s.chart_size = 10;
    s.proxy_triangles = 40;
    s.mean_resolution = 8;
    s.samples = 2;
    s.threads = 1;
    return s;
}

// The quickest: no proxy is built, no mean is fitted.
inline GuidedSettings tiny_focus()
{
    GuidedSettings s = tiny_guided();
    s.surface = format::GuidedSurface::focus;
    s.focus_radius = 0.5f;
    s.used_origins = 5;
    return s;
}

inline std::vector<GuidedSettings> tiny_guided_of_every_kind()
{
    GuidedSettings mean_alone = tiny_guided(), texels_alone = tiny_guided(), bare = tiny_guided(),
                   blocks = tiny_guided();
    mean_alone.texel = format::GuidedTexel::none;
    texels_alone.mean_resolution = 0;
    texels_alone.texel = format::GuidedTexel::index8;
    bare.occlusion = false;
    bare.used_origins = 20;
    bare.mean_format = format::MeanFormat::rgb565;
    blocks.texel = format::GuidedTexel::vq8;
    return {tiny_guided(), mean_alone, texels_alone, bare, blocks, tiny_focus()};
}

inline std::string baked(const Scene& scene, const GuidedSettings& settings)
{
    const GuidedBake bake = guided_field(scene, settings);
    return {bake.file.begin(), bake.file.end()};
}

}  // namespace lumi::baker::testing
