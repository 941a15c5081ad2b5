// SPDX-License-Identifier: MIT
#include "fit/path_plan.h"

#include <algorithm>
#include <cmath>

namespace lumi::baker
{
namespace
{

constexpr double kPrior = 8;          // paths of the mean variance that a patch of few paths is given besides its own
constexpr double kLeastOwn = 0.25;    // of a variance that was measured around means of the same paths
constexpr double kLeastOpen = 0.125;  // share of a patch's lines that nothing stops: no more are spent on it
constexpr double kFewestPaths = 8;    // to a texel
constexpr double kOwnPart = 0.4;      // of the noise of texels, which are smoothed afterwards; tables are not
constexpr double kQuiet = 0.5;        // levels: less noise of a texel is not looked at
constexpr double kMostOfMean = 32;    // times the mean: where little else is noisy, one patch would get all
constexpr int kHalvings = 40;

struct PatchNoise {
    double texels = 0, open = 0;
    double own = 0, tables = 0;  // standard deviations of a path: in a texel's colour, and in what tables are fitted to
    double share = 1;            // of the mean patch's texels: tables of small ones are as large
    bool viewed = false;         // at least one corner has a table

    // Paths to a texel, so many times its deviation.
    double wanted(double per_deviation) const
    {
        const double deviation = kOwnPart * own + tables / std::sqrt(share);
        const double enough = (own + tables) / kQuiet;
        return std::max(kFewestPaths, std::min(enough * enough, per_deviation * std::sqrt(open) * deviation));
    }
};

// Sums of squares of deviations. Those of tables were measured around means of the same paths, so they are too small
// where these are few.
struct Squares {
    double own = 0, tables = 0, paths = 0;
};

Squares squares_of(const PatchSums& patch)
{
    const TexelSums all = scatter_of(patch);
    Squares result;
    result.paths = all.count;
    const double texels = static_cast<double>(patch.texels.size());
    const double unit = kScatterUnit / 3 / std::max(kLeastOwn, 1 - texels / std::max(result.paths, 1.0));
    for (const TexelSums& texel : patch.texels) result.own += unit * static_cast<double>(texel.whole_scatter);
    result.tables = unit * static_cast<double>(all.scatter);
    return result;
}

bool is_viewed(const FitShape& shape, uint32_t patch, const std::vector<uint8_t>& viewed)
{
    for (uint32_t corner = 0; corner < 4; ++corner)
        if (const uint32_t v = shape.vertex(patch, corner); v != PatchMesh::kNone && viewed[v] != 0) return true;
    return false;
}

std::vector<PatchNoise> noise_of(const FitSums& pilot, const std::vector<uint8_t>& viewed, uint32_t lines)
{
    std::vector<Squares> squares;
    Squares all;
    double texels = 0;
    for (const PatchSums& patch : pilot.patches()) {
        squares.push_back(squares_of(patch));
        all = {all.own + squares.back().own, all.tables + squares.back().tables, all.paths + squares.back().paths};
        texels += static_cast<double>(patch.texels.size());
    }
    std::vector<PatchNoise> result;
    const double usual = texels / static_cast<double>(squares.size()), paths = std::max(all.paths, 1.0);
    for (size_t p = 0; p < squares.size(); ++p) {
        const Squares& s = squares[p];
        PatchNoise n;
        n.texels = static_cast<double>(pilot.patches()[p].texels.size());
        n.open = std::clamp(s.paths / (n.texels * lines), kLeastOpen, 1.0);
        n.share = n.texels / usual;
        n.own = std::sqrt((s.own + kPrior * all.own / paths) / (s.paths + kPrior));
        n.tables = std::sqrt((s.tables + kPrior * all.tables / paths) / (s.paths + kPrior));
        n.viewed = is_viewed(pilot.shape(), static_cast<uint32_t>(p), viewed);
        if (!n.viewed) n.tables = 0;
        if (s.paths == 0) n.own = n.tables = 0;
        result.push_back(n);
    }
    return result;
}

double sum_of(const std::vector<PatchNoise>& noise, double per_deviation)
{
    double sum = 0;
    for (const PatchNoise& n : noise) sum += n.texels * n.wanted(per_deviation);
    return sum;
}

// So many paths in all bring the sum of all texels' variances to its least where a texel gets paths by its deviation.
double paths_per_deviation(const std::vector<PatchNoise>& noise, double paths)
{
    double low = 0, high = 1;
    while (sum_of(noise, high) < paths && high < 1e9) high *= 2;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = (low + high) / 2;
        (sum_of(noise, middle) < paths ? low : high) = middle;
    }
    return high;
}

}  // namespace

PathPlan::PathPlan(const SurfaceSettings& settings, const Shard& shard, const FitShape& shape)
    : shard_(shard), paths_per_texel_(settings.paths_per_texel)
{
    uint32_t texels = 0;
    for (const PatchRectangle& r : shape.layout.rectangles) ends_.push_back(texels += r.size());
    batches_ = (texels + kBatchTexels - 1) / kBatchTexels;
    if (shape.mesh.is_matt != 0) return;
    const std::vector<float> densities(shape.mesh.patches.size(), settings.texels_per_radius);
    double allowed = 0;
    for (const PatchRectangle& r : unlimited_layout(shape.mesh, densities).rectangles) allowed += r.size();
    spared_ = std::max(1.0, allowed / std::max(texels, 1u));
}

std::vector<uint32_t> PathPlan::lines(const FitSums& pilot, const std::vector<uint8_t>& viewed) const
{
    const std::vector<PatchNoise> noise = noise_of(pilot, viewed, pilot_lines());
    double paths = 0;
    for (const PatchNoise& n : noise) paths += paths_per_texel_ * n.texels * (n.viewed ? spared_ : 1);
    const double per_deviation = paths_per_deviation(noise, paths);
    const double most =
        std::clamp(kMostOfMean * spared_ * paths_per_texel_, 1.0 * pilot_lines(), kMaxTexelSamples - 1.0);
    std::vector<uint32_t> result;
    for (const PatchNoise& n : noise)
        result.push_back(
            static_cast<uint32_t>(std::clamp(std::ceil(n.wanted(per_deviation) / n.open), 1.0 * pilot_lines(), most)));
    return result;
}

}  // namespace lumi::baker
