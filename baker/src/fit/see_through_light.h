// SPDX-License-Identifier: MIT
// Traces how much light see-through texels let pass, and the light behind them.
#pragma once

#include "fit/sample_tracer.h"
#include "lumi/baker/surface.h"

namespace lumi::baker
{

// By texel of the shape; those of opaque patches say nothing. Empty where there is no see-through patch.
std::vector<SeeThroughTexel> see_through_light(const SceneData& scene, const FitShape& shape,
                                               const SurfaceSettings& settings, const ProgressCallback& progress);

}  // namespace lumi::baker
