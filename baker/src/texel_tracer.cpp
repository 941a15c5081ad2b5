// SPDX-License-Identifier: MIT
#include "texel_tracer.h"

namespace lumi::baker
{

TexelTracer::TexelTracer(const SceneData& scene, const BakeSettings& settings)
    : tone_(scene.tone),
      seed_(settings.seed), samples_(settings.samples), rays_(settings.origins, settings.directions), tracer_(scene)
{
}

Estimate TexelTracer::estimate(const OriginDisc& disc, uint32_t i, uint32_t j) const
{
    Estimate result(tone_);
    const Vec3 target = rays_.direction_point(j);
    Sampler sampler(seed_, i, j);
    for (uint32_t s = 0; s < samples_; ++s) {
        sampler.start(s);
        const std::optional<Ray> ray = FieldRays::ray(disc.at(sampler.next_2d()), target);
        result.add(ray ? tracer_.trace(*ray, sampler) : PathResult{});
    }
    return result;
}

}  // namespace lumi::baker
