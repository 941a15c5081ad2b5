// SPDX-License-Identifier: MIT
// How many light paths a surface bake traces, and to which patches: only this file decides it.
#pragma once

#include "fit/fit_sums.h"
#include "lumi/baker/surface.h"

namespace lumi::baker
{

class PathPlan
{
public:
    PathPlan(const SurfaceSettings& settings, const Shard& shard, const FitShape& shape, const SampleTracer& tracer);

    // Batches of lines (fit/sample_tracer.h). All shards trace the same pilot.
    uint32_t pilot_batches() const;
    // Batches of the shard after the pilot, and the number of the k-th of them: shards take turns.
    uint32_t batches() const;
    uint32_t batch(uint32_t k) const { return k * shard_.count + shard_.index - 1; }
    // By patch, the chance that an extra line goes there, from the pilot's light.
    std::vector<float> extra_chances(const FitSums& pilot) const;

private:
    uint32_t batches_for(double paths) const;

    const Shard shard_;
    const double texels_, paths_per_texel_;
    double paths_per_batch_;
};

// By patch, the chance that an extra line (fit/extra_lines.h) goes there: none where empty, else numbers that sum to 1.
// `pilot` holds the light of `pilot_lines` lines through the sphere. As many extra light paths as `share` of the
// pilot's would bring the sum of all texels' variances to its least: every texel counts alike, however seldom it is
// seen.
std::vector<float> extra_chances(const FitSums& pilot, double pilot_lines, double share);

}  // namespace lumi::baker
