// SPDX-License-Identifier: MIT
#include "fit/gloss/gloss_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/gloss/map_choices.h"
#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

using Colours = GlossColours;
using Choices = std::vector<uint8_t>;
constexpr uint32_t kTexels = kGlossTexels;

// Mean normals of the lines at the vertices, in the sense of least squares over the triangles: by Jacobi's method.
std::vector<Vec3> normals_of(const FitShape& shape, const std::vector<GlossLine>& lines)
{
    constexpr int kRounds = 25;
    constexpr float kPrior = 1;  // lines that stand for the mesh's own normal
    const auto weights = [](const GlossLine& l) {
        return std::array<float, 3>{1 - l.second - l.third, l.second, l.third};
    };
    const auto vertex = [&](const GlossLine& l, uint32_t k) {
        return shape.vertex(l.triangle / 2, FitShape::patch_corner(l.triangle, k));
    };
    std::vector<Vec3> normals = shape.mesh.normals;
    std::vector<float> diagonal(normals.size(), kPrior);
    for (const GlossLine& l : lines)
        for (uint32_t k = 0; k < 3; ++k) diagonal[vertex(l, k)] += weights(l)[k];
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Vec3> steps(normals.size());
        for (const GlossLine& l : lines) {
            const std::array<float, 3> w = weights(l);
            Vec3 off = l.normal;
            for (uint32_t k = 0; k < 3; ++k) off = off - normals[vertex(l, k)] * w[k];
            for (uint32_t k = 0; k < 3; ++k) steps[vertex(l, k)] = steps[vertex(l, k)] + off * w[k];
        }
        for (size_t v = 0; v < normals.size(); ++v) normals[v] = normals[v] + steps[v] * (1 / diagonal[v]);
    }
    for (size_t v = 0; v < normals.size(); ++v)
        normals[v] = length(normals[v]) > 0.1f ? normalized(normals[v]) : shape.mesh.normals[v];
    return normals;
}

// A solution of the lines that are fitted.
struct Solution {
    GlossEquations equations;
    Choices choices;
    Colours unknowns;
};

// The direction in which colours differ most, of unit length, its sum positive: by the power method.
LevelColour main_direction(const Colours& colours)
{
    constexpr int kRounds = 30;
    LevelColour direction = {0.577f, 0.577f, 0.577f};
    for (int round = 0; round < kRounds; ++round) {
        LevelColour sum{};
        for (const LevelColour& c : colours)
            add(sum, c, c[0] * direction[0] + c[1] * direction[1] + c[2] * direction[2]);
        const float size = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        if (!(size > 0)) break;
        direction = {sum[0] / size, sum[1] / size, sum[2] / size};
    }
    return direction;
}

// A map's colours as one colour times bytes. Where it is darkest it adds nothing: texels have the rest.
GlossMap map_of(Colours colours, float& range)
{
    LevelColour mean{};
    for (const LevelColour& c : colours) add(mean, c, 1.0f / kTexels);
    for (LevelColour& c : colours) c = difference(c, mean);
    const LevelColour direction = main_direction(colours);
    std::vector<float> along;
    for (const LevelColour& c : colours)
        along.push_back(c[0] * direction[0] + c[1] * direction[1] + c[2] * direction[2]);
    const auto [least, most] = std::minmax_element(along.begin(), along.end());
    range = *most - *least;
    constexpr float kSteps = 255;
    GlossMap map;
    std::vector<uint8_t> texels;
    for (const float a : along)
        texels.push_back(static_cast<uint8_t>(range > 0 ? std::lround((a - *least) / range * kSteps) : 0));
    for (size_t c = 0; c < 3; ++c)
        map.gains[c] = static_cast<uint8_t>(
            std::clamp(std::lround(direction[c] * range / kSteps * GlossMap::kGainUnit), 0L, 255L));
    map.texels = bordered(texels);
    return map;
}

// Returns the squared light that each map alone adds to the lines.
std::vector<double> shares_of_maps(const Solution& s)
{
    std::vector<double> shares;
    for (size_t first = s.equations.nodes(); first < s.unknowns.size(); first += kTexels) {
        Colours alone(s.unknowns.size());
        std::copy_n(s.unknowns.begin() + static_cast<std::ptrdiff_t>(first), kTexels,
                    alone.begin() + static_cast<std::ptrdiff_t>(first));
        shares.push_back(squares(s.equations.shown(alone)));
    }
    return shares;
}

// Lines that are fitted, and others that judge.
struct SplitLines {
    explicit SplitLines(const std::vector<GlossLine>& lines)
    {
        constexpr size_t kOneOf = 5;
        for (size_t k = 0; k < lines.size(); ++k) (k % kOneOf == 0 ? judging : fitted).push_back(lines[k]);
    }
    std::vector<GlossLine> fitted, judging;  // by texel
};

GlossColours levels_of(const std::vector<GlossLine>& lines)
{
    GlossColours levels;
    for (const GlossLine& l : lines) levels.push_back(l.levels);
    return levels;
}

// The mean of what fitted lines leave to each texel, and how many they are.
struct TexelMean {
    LevelColour sum{};
    float lines = 0;
};

std::vector<TexelMean> texel_means(const std::vector<GlossLine>& fitted, const GlossColours& shown, uint32_t texels)
{
    std::vector<TexelMean> means(texels);
    for (size_t k = 0; k < fitted.size(); ++k) {
        TexelMean& mean = means[fitted[k].texel];
        add(mean.sum, difference(fitted[k].levels, shown[k]), 1);
        ++mean.lines;
    }
    return means;
}

// The squared error of judging lines to texels that have fitted ones, less what noise makes of it.
double judged(const SplitLines& lines, const GlossColours& shown, const GlossColours& shown_to_judge, uint32_t texels)
{
    const std::vector<TexelMean> means = texel_means(lines.fitted, shown, texels);
    double sum = 0;
    for (size_t k = 0; k < lines.judging.size(); ++k) {
        const GlossLine& line = lines.judging[k];
        const TexelMean& mean = means[line.texel];
        if (mean.lines == 0) continue;
        LevelColour off = difference(line.levels, shown_to_judge[k]);
        add(off, mean.sum, -1 / mean.lines);
        sum += squares({off}) - static_cast<double>(line.noise * (1 + 1 / mean.lines));
    }
    return sum;
}

// Solves the problem with maps for these and those patches.
class GlossTrials
{
public:
    GlossTrials(const FitShape& shape, const std::vector<GlossLine>& all, BakeStages& stages, Job& job)
        : shape_(shape),
          normals_(normals_of(shape, all)),
          lines_(all),
          levels_(levels_of(lines_.fitted)),
          stages_(stages),
          job_(job)
    {
        take_means(texel_begins(lines_.fitted), levels_);
    }

    // For each of these choices, side by side. What they are is kept under the name.
    std::vector<Solution> solved(const char* name, const std::vector<Choices>& choices) const
    {
        std::vector<Solution> result;
        for (const Choices& c : choices) result.push_back({equations(lines_.fitted, c), c, {}});
        solve(name, result);
        return result;
    }

    // Returns the error on the lines that judge.
    double error(const Solution& s) const
    {
        return judged(lines_, s.equations.summed(s.unknowns), equations(lines_.judging, s.choices).summed(s.unknowns),
                      shape_.layout.texels);
    }

    Choices split(const Solution& s, uint32_t most) const
    {
        return split_choices(s.equations, s.unknowns, levels_, lines_.fitted, s.choices, most);
    }

    // Keeps maps that show something beside the others and that some patch takes, numbered anew.
    Gloss kept_maps(const Solution& s) const;

private:
    GlossEquations equations(const std::vector<GlossLine>& of, const Choices& choices) const
    {
        return GlossEquations(shape_, of, normals_, choices, *std::max_element(choices.begin(), choices.end()));
    }
    void solve(const char* name, std::vector<Solution>& solutions) const;

    const FitShape& shape_;
    const std::vector<Vec3> normals_;
    const SplitLines lines_;
    Colours levels_;  // of fitted lines, less the mean of each texel
    BakeStages& stages_;
    Job& job_;
};

void GlossTrials::solve(const char* name, std::vector<Solution>& solutions) const
{
    constexpr uint32_t kRounds = 30, kRoundsAtOnce = 5;
    using Steps = std::vector<GlossGradients>;
    const auto is_of = [](const GlossGradients& g, const Solution& s) {
        const size_t unknowns = s.equations.unknowns();
        return g.unknowns.size() == unknowns && g.residual.size() == unknowns && g.direction.size() == unknowns;
    };
    const auto require_shape = [&](const Steps& steps) {
        stages_.require_shape(std::equal(steps.begin(), steps.end(), solutions.begin(), solutions.end(), is_of));
    };
    const auto advance = [&](uint32_t k, Steps& steps) {
        if (k != 0) require_shape(steps);
        steps.resize(solutions.size());
        job_.run(static_cast<uint32_t>(steps.size()), [&](uint32_t one) {
            const GlossSolver solver(solutions[one].equations, levels_);
            if (k == 0) steps[one] = solver.begun();
            for (uint32_t round = 0; round < kRoundsAtOnce; ++round) solver.advance(steps[one]);
        });
        return true;
    };
    Steps steps = stages_.in_steps<Steps>(name, kRounds / kRoundsAtOnce, advance);
    require_shape(steps);
    for (size_t one = 0; one < steps.size(); ++one) solutions[one].unknowns = std::move(steps[one].unknowns);
}

Gloss GlossTrials::kept_maps(const Solution& s) const
{
    constexpr float kLeastRange = 16;     // levels along the main direction
    constexpr double kLeastShare = 0.15;  // of what all add
    const std::vector<double> shares = shares_of_maps(s);
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::vector<GlossMap> maps;
    Choices shown;  // numbers of those maps
    for (size_t k = 0; k < shares.size(); ++k) {
        float range = 0;
        const auto begin = s.unknowns.begin() + static_cast<std::ptrdiff_t>(s.equations.nodes() + k * kTexels);
        GlossMap map = map_of(Colours(begin, begin + kTexels), range);
        if (range < kLeastRange || shares[k] < kLeastShare * all) continue;
        maps.push_back(std::move(map));
        shown.push_back(static_cast<uint8_t>(k + 1));
    }
    const Choices chosen =
        choices_among(shown, s.equations, s.unknowns, levels_, lines_.fitted, shape_.mesh, s.choices);
    Gloss gloss;
    std::array<uint8_t, detail::format::kMaxGlossMaps + 1> numbers{};
    for (size_t k = 0; k < maps.size(); ++k) {
        if (std::find(chosen.begin(), chosen.end(), shown[k]) == chosen.end()) continue;
        gloss.maps.push_back(std::move(maps[k]));
        numbers[shown[k]] = static_cast<uint8_t>(gloss.maps.size());
    }
    if (!gloss.is_there()) return {};
    for (const uint8_t choice : chosen) gloss.choices.push_back(numbers[choice]);
    gloss.normals = normals_;
    return gloss;
}

}  // namespace

bool may_gloss(const SceneData& scene, const PatchMesh& mesh, const SurfaceSettings& settings)
{
    const bool has_edges = scene.choice.environment.picture != nullptr || !scene.fixtures.empty();
    return has_edges && settings.gloss_maps != 0 && settings.view_tables && !settings.draft && mesh.is_matt == 0 &&
           scene.states.names.empty() && !scene.medium;
}

Gloss gloss_of(const SceneData& scene, const FitShape& shape, const SurfaceSettings& settings, BakeStages& stages,
               const ProgressCallback& progress)
{
    constexpr size_t kFewest = 1000;
    if (!may_gloss(scene, shape.mesh, settings)) return {};
    constexpr double kMostLeft = 0.95;  // of the error without maps
    Job job(1, settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), 20);
    const GlossLines all = gloss_lines(scene, shape, settings, stages, job);
    if (all.lines.size() < kFewest) return {};
    const GlossTrials trials(shape, all.lines, stages, job);
    const Choices one = choices_of_one(all);
    const std::vector<Solution> both = trials.solved("gloss", {one, Choices(one.size())});
    std::vector<Choices> choices = {trials.split(both[0], settings.gloss_maps),
                                    choices_by_material(all, scene.materials.size(), settings.gloss_maps)};
    choices.erase(std::remove(choices.begin(), choices.end(), one), choices.end());
    const std::vector<Solution> finer = trials.solved("gloss of more maps", choices);
    const Solution* best = &both[0];
    double least = trials.error(*best);
    for (const Solution& s : finer) {
        const double error = trials.error(s);
        if (error >= least) continue;
        least = error;
        best = &s;
    }
    // Where noise is all that is left, whatever takes something pays.
    const double without = trials.error(both[1]);
    return least > std::min(kMostLeft * without, without) ? Gloss{} : trials.kept_maps(*best);
}

}  // namespace lumi::baker
