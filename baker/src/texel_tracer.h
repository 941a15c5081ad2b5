// SPDX-License-Identifier: MIT
// The estimate of one texel: a pure function of scene, settings and the texel's place.
#pragma once

#include "estimate.h"
#include "field_rays.h"
#include "lumi/baker/bake.h"
#include "path_tracer.h"

namespace lumi::baker
{

class TexelTracer
{
public:
    TexelTracer(const SceneData& scene, const BakeSettings& settings);  // borrows the scene

    OriginDisc disc(uint32_t i) const { return rays_.disc(i); }
    // `disc` is disc(i), which a row shares. Any number of threads may call it.
    Estimate estimate(const OriginDisc& disc, uint32_t i, uint32_t j) const;

private:
    ToneCurve tone_;
    uint64_t seed_;
    uint32_t samples_;
    FieldRays rays_;
    PathTracer tracer_;
};

}  // namespace lumi::baker
