// SPDX-License-Identifier: MIT
// Traces the light of a surface field into sums.
//
// A pilot of few paths, kept one by one, finds about which levels each sample shows; then they and every further path
// are added to sums that are linear around those.
#pragma once

#include <functional>

#include "fit/fit_solver.h"
#include "fit/fit_state.h"
#include "fit/path_plan.h"
#include "store/bake_stages.h"

namespace lumi::baker
{

class LightFit
{
public:
    // Borrows all.
    LightFit(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings, const Shard& shard);

    // The part of all work up to the solution that a state already holds, in light paths that take as long.
    uint64_t work_in(const FitState& state) const;
    // The rest of it: light paths, and other work.
    uint64_t rays_left(const FitState& state) const;
    uint64_t staged_left(const FitState& state) const { return state.has_pilot ? 0 : pilot_work(); }

    // Goes on from `state` until all paths of the shard are in it; `keep` is called when some more are. Throws
    // Cancelled, with what is whole in the state.
    void trace(FitState& state, BakeStages& stages, Job& job, const std::function<void()>& keep);
    // Drops what the stages keep of the pilot; it is not needed once its result is kept elsewhere.
    static void forget_pilot(BakeStages& stages);

private:
    uint64_t pilot_work() const;
    double lines_a_path() const;
    void pilot(FitState& state, BakeStages& stages, Job& job) const;
    // Those of `count` batches, of which number(k) is the k-th's number.
    template <class Number>
    SampleBatches traced(Number number, uint32_t count, Job& job, uint64_t seed,
                         const std::vector<uint32_t>& lines) const;
    SortedSamples pilot_samples(BakeStages& stages, Job& job) const;
    SortedSamples by_patch(const SampleBatches& batches) const;

    const FitShape& shape_;
    const SurfaceSettings& settings_;
    const SampleTracer tracer_;
    const PathPlan paths_;
    const double lines_a_path_;  // estimated, for the time left
};

}  // namespace lumi::baker
