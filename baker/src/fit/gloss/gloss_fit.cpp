// SPDX-License-Identifier: MIT
#include "fit/gloss/gloss_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/gloss/equations.h"
#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

using Colours = GlossColours;
constexpr uint32_t kTexels = kGlossTexels;
constexpr uint8_t kNoMap = 0;

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

// Two problems that are solved side by side.
struct GlossSteps {
    GlossGradients with, without;
};

template <class Io>
void fields(Io& io, GlossSteps& steps)
{
    io(steps.with, steps.without);
}

bool are_of(const GlossGradients& g, const GlossEquations& equations)
{
    const size_t unknowns = equations.unknowns();
    return g.unknowns.size() == unknowns && g.residual.size() == unknowns && g.direction.size() == unknowns;
}

// The unknowns with maps and without.
GlossSteps solved_both(const GlossEquations& with, const GlossEquations& without, const Colours& levels,
                       BakeStages& stages, Job& job)
{
    constexpr uint32_t kRounds = 30, kRoundsAtOnce = 5;
    const GlossSolver solvers[] = {GlossSolver(with, levels), GlossSolver(without, levels)};
    const auto require_shape = [&](const GlossSteps& s) {
        stages.require_shape(are_of(s.with, with) && are_of(s.without, without));
    };
    const auto advance = [&](uint32_t k, GlossSteps& steps) {
        if (k != 0) require_shape(steps);
        job.run(2, [&](uint32_t one) {
            GlossGradients& g = one == 0 ? steps.with : steps.without;
            if (k == 0) g = solvers[one].begun();
            for (uint32_t round = 0; round < kRoundsAtOnce; ++round) solvers[one].advance(g);
        });
        return true;
    };
    GlossSteps steps = stages.in_steps<GlossSteps>("gloss", kRounds / kRoundsAtOnce, advance);
    require_shape(steps);
    return steps;
}

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

// By patch: the map of the material that most lines to it meet. The materials that most lines meet get a map, numbered
// from 1.
std::vector<uint8_t> choices_of(const GlossLines& all, size_t materials, uint32_t most)
{
    const std::vector<GlossLine>& lines = all.lines;
    std::vector<size_t> count(materials);
    for (const GlossLine& l : lines) ++count[l.material];
    std::vector<uint32_t> order(materials);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return count[a] > count[b]; });
    std::vector<uint8_t> map_of_material(materials, kNoMap);
    for (uint32_t k = 0; k < std::min(most, detail::format::kMaxGlossMaps) && k < materials; ++k)
        if (count[order[k]] != 0) map_of_material[order[k]] = static_cast<uint8_t>(k + 1);
    std::vector<std::array<uint32_t, detail::format::kMaxGlossMaps + 1>> votes(all.others.size());
    for (size_t p = 0; p < votes.size(); ++p) votes[p][kNoMap] = all.others[p];
    for (const GlossLine& l : lines) ++votes[l.triangle / 2][map_of_material[l.material]];
    std::vector<uint8_t> choices;
    for (const auto& v : votes)
        choices.push_back(static_cast<uint8_t>(std::max_element(v.begin(), v.end()) - v.begin()));
    return choices;
}

// What each map alone adds to the lines, squared.
std::vector<double> shares_of_maps(const GlossEquations& e, const Colours& unknowns)
{
    std::vector<double> shares;
    for (size_t first = e.nodes(); first < unknowns.size(); first += kTexels) {
        Colours alone(unknowns.size());
        std::copy_n(unknowns.begin() + static_cast<std::ptrdiff_t>(first), kTexels,
                    alone.begin() + static_cast<std::ptrdiff_t>(first));
        shares.push_back(squares(e.shown(alone)));
    }
    return shares;
}

// Keeps maps that show something beside the others, numbered anew.
Gloss kept_maps(const GlossEquations& e, const Colours& unknowns, std::vector<uint8_t> choices,
                std::vector<Vec3> normals)
{
    constexpr float kLeastRange = 16;     // levels along the main direction
    constexpr double kLeastShare = 0.15;  // of what all add
    const size_t nodes = e.nodes();
    const std::vector<double> shares = shares_of_maps(e, unknowns);
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    Gloss gloss;
    std::array<uint8_t, detail::format::kMaxGlossMaps + 1> numbers{};
    for (size_t k = 0; nodes + (k + 1) * kTexels <= unknowns.size(); ++k) {
        float range = 0;
        const auto begin = unknowns.begin() + static_cast<std::ptrdiff_t>(nodes + k * kTexels);
        GlossMap map = map_of(Colours(begin, begin + kTexels), range);
        if (range < kLeastRange || shares[k] < kLeastShare * all) continue;
        gloss.maps.push_back(std::move(map));
        numbers[k + 1] = static_cast<uint8_t>(gloss.maps.size());
    }
    if (!gloss.is_there()) return {};
    for (uint8_t& choice : choices) choice = numbers[choice];
    gloss.choices = std::move(choices);
    gloss.normals = std::move(normals);
    return gloss;
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
    constexpr double kMostLeft = 0.9;  // of the error without maps
    Job job(1, settings.threads, progress);
    const JobStage stage(job, Stage::mesh, job.part_of_rest(1), 20);
    const GlossLines all = gloss_lines(scene, shape, settings, stages, job);
    if (all.lines.size() < kFewest) return {};
    const std::vector<uint8_t> choices = choices_of(all, scene.materials.size(), settings.gloss_maps);
    const std::vector<Vec3> normals = normals_of(shape, all.lines);
    const uint32_t maps = *std::max_element(choices.begin(), choices.end());
    const SplitLines lines(all.lines);
    const auto equations = [&](const std::vector<GlossLine>& of, uint32_t count) {
        return GlossEquations(shape, of, normals, choices, count);
    };
    const GlossEquations with = equations(lines.fitted, maps), without = equations(lines.fitted, 0);
    GlossColours levels = levels_of(lines.fitted);
    with.take_means(levels);
    const GlossSteps solved = solved_both(with, without, levels, stages, job);
    const auto error = [&](const GlossEquations& fitted, const GlossColours& unknowns, uint32_t count) {
        return judged(lines, fitted.summed(unknowns), equations(lines.judging, count).summed(unknowns),
                      shape.layout.texels);
    };
    if (error(with, solved.with.unknowns, maps) > kMostLeft * error(without, solved.without.unknowns, 0)) return {};
    return kept_maps(with, solved.with.unknowns, choices, normals);
}

}  // namespace lumi::baker
