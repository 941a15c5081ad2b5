// SPDX-License-Identifier: MIT
// Light along lines to the smooth surfaces of a scene, a few paths a line: what gloss maps are learnt from.
#pragma once

#include "fit/encoded_tone.h"
#include "fit/fit_shape.h"
#include "store/bake_stages.h"
#include "util/job.h"

namespace lumi::baker
{

// Weights of corners are barycentric, those of the second and the third.
struct GlossLine {
    uint32_t triangle, texel;  // 2p or 2p + 1 of patch p
    uint32_t material;
    float second, third;
    Vec3 eye, normal;    // the scene's shading normal
    LevelColour levels;  // of the mean light, without the darkening by its noise
    float noise;         // the channels' variances, summed
};

template <class Io>
void fields(Io& io, GlossLine& line)
{
    io(line.triangle, line.texel, line.material, line.second, line.third, line.eye, line.normal, line.levels,
       line.noise);
}

// Whether a material mirrors something that is sharper than view tables are.
bool is_smooth(const Material& material);

struct GlossLines {
    std::vector<GlossLine> lines;  // sorted by texel
    std::vector<uint32_t> others;  // by patch: how many lines met something that is not smooth there
};

// Uniform over all lines that meet the unit sphere. A bake that is killed meanwhile goes on from what `stages` kept.
GlossLines gloss_lines(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings,
                       BakeStages& stages, Job& job);
// Forgets what they kept, and all since then.
void forget_gloss_lines(BakeStages& stages);

}  // namespace lumi::baker
