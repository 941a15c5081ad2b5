// SPDX-License-Identifier: MIT
#include "pack/solution.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fit/fit_model.h"
#include "fit/fit_solver.h"
#include "fit/texel_finish.h"
#include "image/tone.h"
#include "pack/state_mix.h"
#include "pack/surface_writer.h"
#include "pack/texel_palette.h"
#include "pack/view_quantiser.h"
#include "scene/light_states.h"

namespace lumi::baker
{

namespace
{

// View tables change what is added, which the coverage has multiplied.
void cover_views(const FitShape& shape, std::vector<ViewCode>& views)
{
    struct CoverageSum {
        float sum = 0, count = 0;
    };
    std::vector<CoverageSum> coverage(views.size());
    for (size_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        for (uint32_t corner = 0; corner < 4; ++corner) {
            const uint32_t v = shape.vertex(static_cast<uint32_t>(p), corner);
            if (v == PatchMesh::kNone) continue;
            for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) coverage[v].sum += shape.see_through[t].coverage;
            coverage[v].count += static_cast<float>(r.size());
        }
    }
    for (size_t v = 0; v < views.size(); ++v) {
        if (coverage[v].count == 0 || !views[v].is_there()) continue;
        const float share = coverage[v].sum / coverage[v].count;
        for (uint8_t& gain : views[v].gains)
            if (gain != 0) gain = static_cast<uint8_t>(std::max(std::lround(share * static_cast<float>(gain)), 1L));
    }
}

// Levels, root mean square. Tables that show less take a tenth of a file and gain nothing (docs/log/surface.md).
constexpr double kLeastDifference = 8;
constexpr int kMostIterations = 60, kIterationsAtOnce = 10;
// Light paths a texel that take as long: without view tables, and where all vertices have one.
constexpr double kPlainWork = 10, kTableWork = 50;

class Solution
{
public:
    Solution(const FitState& state, BakeStages& stages, Job& job)
        : state_(state), smoothness_(state.shape, state.expected.viewed), stages_(stages), job_(job)
    {
    }

    // From `model` on.
    void solve(FitModel& model, const char* name)
    {
        FitSolver solver(state_.sums, smoothness_, model.viewed, job_);
        smoothness_.learn(state_.sums, model);
        const auto advance = [&](uint32_t k, ConjugateGradients& gradients) {
            if (k == 0) gradients = solver.begun(model);
            stages_.require_shape(is_of(gradients, state_.shape));
            if (gradients.done) return false;
            solver.advance(gradients, kIterationsAtOnce);
            return true;
        };
        const ConjugateGradients gradients =
            stages_.in_steps<ConjugateGradients>(name, kMostIterations / kIterationsAtOnce, advance);
        stages_.require_shape(is_of(gradients, state_.shape));
        solver.take(gradients, model);
    }
    // The texels that go with these nodes.
    void refit_texels(FitModel& model) const
    {
        FitSolver(state_.sums, smoothness_, {}, job_).fit_texels(model);
        finish_texels(state_.sums, state_.tone, model);
    }

private:
    const FitState& state_;
    ViewSmoothness smoothness_;
    BakeStages& stages_;
    Job& job_;
};

}  // namespace

uint64_t solution_work(const FitState& state)
{
    const std::vector<uint8_t>& viewed = state.expected.viewed;
    const auto count =
        static_cast<double>(std::count_if(viewed.begin(), viewed.end(), [](uint8_t v) { return v != 0; }));
    const double share = viewed.empty() ? 0 : count / static_cast<double>(viewed.size());
    return static_cast<uint64_t>((kPlainWork + kTableWork * share) * state.shape.layout.texels);
}

namespace
{

// Those that show the most differences, no more than were planned for.
std::vector<uint8_t> planned_vertices(const FitSums& sums, const FitModel& model, double least)
{
    constexpr double kStep = 1.1;
    const uint32_t most = most_viewed_vertices(sums.shape().mesh);
    for (;; least *= kStep) {
        std::vector<uint8_t> viewed = viewed_vertices(sums, model, least);
        if (std::count(viewed.begin(), viewed.end(), 1) <= most) return viewed;
    }
}

// A state of the light while its colours are found.
struct Solving {
    Solving(const TracedLight& of, Job& job) : light(of), solution(of.state, of.stages, job), model(of.state.expected)
    {
    }

    const TracedLight& light;
    Solution solution;
    FitModel model;
};

// A tint shows what its colour adds to the first light.
void part_tints(const FitShape& shape, std::vector<Solving>& lights)
{
    if (!lights.back().light.is_tint) return;
    FitModel base = lights[0].model;
    lights[0].solution.refit_texels(base);
    for (Solving& light : lights) {
        if (!light.light.is_tint) continue;
        light.solution.refit_texels(light.model);
        take_away(shape, base, light.model);
    }
}

// The texels and view tables of all states, in the format's bits.
class Packing
{
public:
    Packing(const FitShape& shape, std::vector<Solving>& lights) : shape_(shape), lights_(lights)
    {
        for (const Solving& l : lights) {
            const Rgb8 usual = srgb_encode(l.light.usual);
            usual_.push_back(usual);
            factors_.push_back(Rgb{srgb_decode(usual.r), srgb_decode(usual.g), srgb_decode(usual.b)} * l.light.scale);
            levels_.push_back({l.model.texels, l.light.scale, factors_.back()});
        }
    }

    // By vertex: whether some state needs its table.
    void quantise_views()
    {
        std::vector<uint8_t> viewed(shape_.mesh.positions.size());
        for (const Solving& l : lights_)
            for (size_t v = 0; v < viewed.size(); ++v) viewed[v] = viewed[v] != 0 || l.model.viewed[v] != 0 ? 1 : 0;
        std::vector<ViewLayer> layers;
        for (const Solving& l : lights_) layers.push_back({l.light.state.sums, l.model, times_seen(l.light.scale)});
        const auto count = static_cast<uint32_t>(std::count(viewed.begin(), viewed.end(), 1));
        const auto states = static_cast<uint32_t>(lights_.size());
        // Maps take bytes that tables have in plan.
        const uint64_t planned = planned_view_bytes(shape_.mesh, true, states),
                       gloss = gloss_file_bytes(shape_.mesh, shape_.gloss.maps.size());
        views_ = quantised(layers, viewed, code_bits_for(planned > gloss ? planned - gloss : 0, count, states));
        for (size_t k = 0; k < views_.size(); ++k) lights_[k].model.nodes = decoded(views_[k]);
    }

    FieldParts parts(const FieldSphere& sphere, const EncodedTone& tone, size_t kept)
    {
        const bool has_states = lights_.size() > 1;
        PalettedTexels texels =
            paletted(shape_, tone, levels_, has_states ? mixed_texels(levels_) : levels_[0].texels, kept);
        for (QuantisedViews& views : views_) cover_views(shape_, views.views);
        FieldParts parts = {sphere.centre, sphere.radius, texels.palettes[0], std::move(texels.texels), {}, {}};
        QuantisedViews views = views_[0];
        if (has_states) {
            parts.means = mean_entries(shape_, levels_, texels.palettes);
            views = mixed_views(views_, texels.palettes, factors_, parts.means);
            parts.palette = mixed_colours(texels.palettes);
            put_states(texels, parts);
        }
        parts.node_colours = std::move(views.colours);
        parts.views = std::move(views.views);
        const PaletteColours added = has_states ? mixed_colours(texels.added) : texels.added[0];
        for (size_t k = 0; k < added.size(); ++k) parts.see_through[k] = {added[k], texels.passed[k]};
        return parts;
    }

private:
    PaletteColours mixed_colours(const std::vector<PaletteColours>& palettes) const
    {
        PaletteColours result;
        std::vector<LevelColour> levels(palettes.size());
        for (size_t k = 0; k < result.size(); ++k) {
            for (size_t s = 0; s < palettes.size(); ++s) levels[s] = levels_of(palettes[s][k]);
            const LevelColour c = mixed(levels, factors_);
            const auto byte = [](float v) { return static_cast<uint8_t>(std::lround(v)); };
            result[k] = {byte(c[0]), byte(c[1]), byte(c[2])};
        }
        return result;
    }

    void put_states(const PalettedTexels& texels, FieldParts& parts)
    {
        for (size_t k = 0; k < lights_.size(); ++k)
            parts.states.push_back({lights_[k].light.name, lights_[k].light.scale, usual_[k], lights_[k].light.is_tint,
                                    texels.palettes[k], texels.added[k], std::move(views_[k].colours),
                                    std::move(views_[k].views)});
    }

    const FitShape& shape_;
    std::vector<Solving>& lights_;
    LevelsOfStates levels_;
    std::vector<Rgb8> usual_;
    std::vector<Rgb> factors_;
    std::vector<QuantisedViews> views_;
};

}  // namespace

FieldParts solved(const std::vector<TracedLight>& lights, const FieldSphere& sphere, Job& job, size_t kept)
{
    const auto runs = static_cast<uint32_t>(2 * kMostIterations * lights.size());
    const JobStage stage(job, Stage::solving, job.part_of_rest(1), runs);
    const FitShape& shape = lights[0].state.shape;
    std::vector<Solving> solving;
    solving.reserve(lights.size());
    for (const TracedLight& light : lights) {
        FitState& state = light.state;
        for_patches(shape, job, [&](uint32_t p) { state.sums.patches()[p].pairs.sort(); });
        state.sums.weigh(state.lines);
        FitModel& model = solving.emplace_back(light, job).model;
        Solution& solution = solving.back().solution;
        solution.solve(model, "all tables");
        const double least = kLeastDifference / static_cast<double>(times_seen(light.scale));
        job.run(1, [&](uint32_t) { model.viewed = planned_vertices(state.sums, model, least); });
        solution.solve(model, "tables");
    }
    job.run(1, [&](uint32_t) { part_tints(shape, solving); });
    Packing packing(shape, solving);
    job.run(1, [&](uint32_t) { packing.quantise_views(); });
    FieldParts parts;
    job.run(1, [&](uint32_t) {
        for (Solving& light : solving)
            if (!light.light.is_tint) light.solution.refit_texels(light.model);
        parts = packing.parts(sphere, lights[0].state.tone, kept);
    });
    return parts;
}

}  // namespace lumi::baker
