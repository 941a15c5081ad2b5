// SPDX-License-Identifier: MIT
#include "fit/path_plan.h"

#include <algorithm>
#include <cmath>

#include "fit/extra_lines.h"
#include "math/warp.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kShareSeedOffset = 0x73686172;
constexpr uint32_t kShareBatches = 16;
constexpr double kPilotPaths = 65;        // a texel; more gain nothing
constexpr double kMaxPilotPaths = 1.6e7;  // for all texels together: they are kept in memory
constexpr double kExtraShare = 0.33;      // extra paths: 1 line of 4 beside 3

constexpr double kPrior = 8;        // paths of the mean variance that a patch of few paths is given besides its own
constexpr double kLeastOwn = 0.25;  // of a variance that was measured around means of the same paths
constexpr double kLeastOpen = 1 / 32.0;  // share of a patch's lines that nothing stops: no more are spent on it
constexpr int kHalvings = 40;

struct PatchNoise {
    double texels = 0, paths = 0, deviation = 0, area = 0;

    // Extra paths where a texel of deviation 1 gets `per_deviation` paths.
    double extra(double per_deviation) const { return std::max(0.0, texels * deviation * per_deviation - paths); }
};

// Residuals were measured around means of the same paths, so they are too small where these are few.
double squares_of(const TexelSums& all, double texels)
{
    const double paths = all.count;
    return all.variance() * paths / std::max(kLeastOwn, 1 - texels / std::max(paths, 1.0));
}

std::vector<PatchNoise> noise_of(const FitSums& pilot)
{
    std::vector<PatchNoise> result;
    const std::vector<float> areas = patch_areas(pilot.shape().mesh);
    double squares = 0, paths = 0;
    for (uint32_t p = 0; p < pilot.patches().size(); ++p) {
        const TexelSums all = scatter_of(pilot.patches()[p]);
        const auto texels = static_cast<double>(pilot.patches()[p].texels.size());
        result.push_back(
            {texels, static_cast<double>(all.count), squares_of(all, texels), static_cast<double>(areas[p])});
        squares += result.back().deviation;
        paths += result.back().paths;
    }
    const double mean = paths > 0 ? squares / paths : 0;
    for (PatchNoise& n : result)
        n.deviation = n.paths > 0 ? std::sqrt((n.deviation + kPrior * mean) / (n.paths + kPrior)) : 0;
    return result;
}

double sum_of(const std::vector<PatchNoise>& noise, double per_deviation)
{
    double sum = 0;
    for (const PatchNoise& n : noise) sum += n.extra(per_deviation);
    return sum;
}

// How many paths a texel of deviation 1 gets, where there are so many extra ones.
double paths_per_deviation(const std::vector<PatchNoise>& noise, double extra)
{
    double low = 0, high = 1;
    while (sum_of(noise, high) < extra && high < 1e12) high *= 2;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (low + high) / 2;
        (sum_of(noise, middle) < extra ? low : high) = middle;
    }
    return high;
}

}  // namespace

std::vector<float> extra_chances(const FitSums& pilot, double pilot_lines, double share)
{
    const std::vector<PatchNoise> noise = noise_of(pilot);
    double paths = 0;
    for (const PatchNoise& n : noise) paths += n.paths;
    const double per_deviation = paths_per_deviation(noise, share * paths);
    std::vector<double> lines;
    double all = 0;
    for (const PatchNoise& n : noise) {
        // A line of random direction and place meets a side of a small area A with the chance A/4π.
        const double open = n.paths / std::max(pilot_lines * n.area / (4 * static_cast<double>(kPi)), 1e-9);
        lines.push_back(n.extra(per_deviation) / std::clamp(open, kLeastOpen, 1.0));
        all += lines.back();
    }
    std::vector<float> result;
    for (const double l : lines) result.push_back(static_cast<float>(all > 0 ? l / all : 0));
    return all > 0 ? result : std::vector<float>();
}

PathPlan::PathPlan(const SurfaceSettings& settings, const Shard& shard, const FitShape& shape,
                   const SampleTracer& tracer)
    : shard_(shard), texels_(shape.layout.texels), paths_per_texel_(settings.paths_per_texel)
{
    uint32_t lines = 0;
    for (uint32_t k = 0; k < kShareBatches; ++k) lines += tracer.meeting(settings.seed + kShareSeedOffset, k).scene;
    paths_per_batch_ = std::max(1.0, lines / static_cast<double>(kShareBatches));
}

uint32_t PathPlan::batches_for(double paths) const
{
    return static_cast<uint32_t>(std::ceil(paths / paths_per_batch_));
}

uint32_t PathPlan::pilot_batches() const
{
    return batches_for(std::min(kPilotPaths * texels_, kMaxPilotPaths));
}

uint32_t PathPlan::batches() const
{
    return (batches_for(paths_per_texel_ * texels_) + shard_.count - shard_.index) / shard_.count;
}

std::vector<float> PathPlan::extra_chances(const FitSums& pilot) const
{
    return baker::extra_chances(pilot, double{SampleTracer::kLines} * pilot_batches(), kExtraShare);
}

}  // namespace lumi::baker
