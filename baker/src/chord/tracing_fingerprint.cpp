// SPDX-License-Identifier: MIT
#include "chord/tracing_fingerprint.h"

#include "chord/texel_tracer.h"
#include "util/digest.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kPathProbes = 2048;
constexpr uint64_t kProbeSeed = 0x70726F6265;

}  // namespace

uint64_t tracing_fingerprint(const SceneData& scene)
{
    BakeSettings settings;
    settings.origins = settings.directions = kPathProbes;
    settings.samples = 1;
    settings.seed = kProbeSeed;
    const TexelTracer texels(scene, settings);
    const FieldRays rays(kPathProbes, kPathProbes);
    const PathTracer tracer(scene);
    Digest digest;
    for (uint32_t k = 0; k < kPathProbes; ++k) {
        const uint32_t j = static_cast<uint32_t>(uint64_t{k} * 0x9E3779B9u % kPathProbes);
        digest.add(texels.estimate(texels.disc(k), k, j).covered_colour());
        Sampler sampler(kProbeSeed, k, j);
        sampler.start(0);
        if (const auto ray = FieldRays::ray(texels.disc(k).at({}), rays.direction_point(j))) {
            const PathResult path = tracer.trace(*ray, sampler);
            digest.add(path.covered);
            digest.add(path.radiance);
        }
    }
    return digest.value()[0];
}

}  // namespace lumi::baker
