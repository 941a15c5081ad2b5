// SPDX-License-Identifier: MIT
// How many light paths a surface bake traces, and to which patches: only this file decides it.
#pragma once

#include <algorithm>
#include "fit/fit_sums.h"
#include "lumi/baker/surface.h"

namespace lumi::baker
{

// Texels are counted patch after patch, whose rectangles may lie in any order. A batch is a number of them in that
// order, with all of their light paths.
class PathPlan
{
public:
    static constexpr uint32_t kBatchTexels = 64;
    // Borrows the shape.
    PathPlan(const SurfaceSettings& settings, const Shard& shard, const FitShape& shape);

    // f(patch, texel) for the texels of a batch; `texel` counts from the patch's first.
    template <class Function>
    void each_texel(uint32_t batch, Function f) const;

    // All shards trace the same pilot, so many lines to each texel. Its light counts in the sums of the first.
    uint32_t pilot_batches() const { return batches_; }
    uint32_t pilot_lines() const { return std::clamp(kMostPilot / std::max(ends_.back(), 1u), 1u, kMostPilotLines); }
    bool counts_pilot() const { return shard_.index == 1; }
    // Batches of the shard after the pilot, and the number of the k-th of them: shards take turns.
    uint32_t batches() const { return (batches_ + shard_.count - shard_.index) / shard_.count; }
    uint32_t batch(uint32_t k) const { return k * shard_.count + shard_.index - 1; }

    // By patch, the lines to each of its texels, the pilot's among them: as many as its noise needs and the settings
    // allow, and where that is less, the pilot's, which take nothing from the others. Where a view table is fitted,
    // texels that the plan spares leave their lines to the others: a table is as large as it was.
    std::vector<uint32_t> lines(const FitSums& pilot, const std::vector<uint8_t>& viewed) const;
    // Lines to a texel that the settings allow in the mean, if nothing stops them, and those of them after the pilot.
    uint32_t mean_lines() const { return static_cast<uint32_t>(paths_per_texel_ * spared_); }
    uint32_t most_lines() const { return after_pilot(mean_lines()); }
    uint32_t after_pilot(uint32_t lines) const { return lines - std::min(lines, pilot_lines()); }

private:
    static constexpr uint32_t kMostPilotLines = 32;
    static constexpr uint32_t kMostPilot = 4'000'000;  // they are kept, in memory and on disk

    const Shard shard_;
    const uint32_t paths_per_texel_;
    std::vector<uint32_t> ends_;  // by patch, in texels
    uint32_t batches_;
    double spared_ = 1;  // texels that the settings allow, for each that there is; of matt meshes 1
};

template <class Function>
void PathPlan::each_texel(uint32_t batch, Function f) const
{
    const uint32_t begin = batch * kBatchTexels, end = std::min(ends_.back(), begin + kBatchTexels);
    auto patch = static_cast<uint32_t>(std::upper_bound(ends_.begin(), ends_.end(), begin) - ends_.begin());
    for (uint32_t k = begin; k < end; ++k) {
        if (k == ends_[patch]) ++patch;
        f(patch, k - (patch == 0 ? 0 : ends_[patch - 1]));
    }
}

}  // namespace lumi::baker
