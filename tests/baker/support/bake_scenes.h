// SPDX-License-Identifier: MIT
// Scenes and settings whose bakes take milliseconds.
#pragma once

#include "lumi/baker/chord.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{

// A glossy ball, of so many rings, over a floor.
inline Scene ball_over_floor(int rings, const Environment& environment, float ball_colour = 0.7f)
{
    SceneMaker maker;
    maker.ball(maker.add(glossy({ball_colour, 0.3f, 0.1f}, 0.3f)), {0, 0, 0.2f}, 0.4f, rings);
    const uint32_t floor = maker.add(diffuse({0.2f, 0.5f, 0.3f}));
    maker.quad(floor, {-0.6f, -0.6f, -0.3f}, {0.6f, -0.6f, -0.3f}, {0.6f, 0.6f, -0.3f}, {-0.6f, 0.6f, -0.3f});
    return maker.make(environment);
}

inline Scene tiny_scene(float ball_colour = 0.7f, float sky = 1)
{
    return ball_over_floor(6, constant_environment(sky), ball_colour);
}

inline BakeSettings tiny_settings(TexelFormat texel = TexelFormat::rgb888)
{
    BakeSettings s;
    s.origins = 9;
    s.directions = 11;
    s.texel = texel;
    s.samples = 2;
    s.threads = 1;
    return s;
}

inline std::string baked(const Scene& scene, const BakeSettings& settings)
{
    const ScratchFolder folder;
    bake_field(scene, settings, folder.at("f.lumi"));
    return read_bytes(folder.at("f.lumi"));
}

// Cancels once `rays` are traced; leaves the checkpoint.
inline ProgressCallback stop_after(uint64_t rays)
{
    return [rays](const Progress& p) { return p.rays_done < rays; };
}

}  // namespace lumi::baker::testing
