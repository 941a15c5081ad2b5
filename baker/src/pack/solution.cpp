// SPDX-License-Identifier: MIT
#include "pack/solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fit/encoded_tone.h"
#include "fit/fit_solver.h"
#include "fit/starved_patches.h"
#include "fit/texel_finish.h"
#include "image/palette.h"
#include "lumi/color.h"
#include "lumi/field_format.h"
#include "pack/see_through_palette.h"
#include "pack/view_quantiser.h"

namespace lumi::baker
{
namespace
{

struct PalettedTexels {
    std::array<Rgb8, detail::format::kPaletteEntries> palette{};
    std::vector<uint8_t> texels;
};

constexpr uint64_t kTexelPaletteSeed = 0x73706C;
constexpr size_t kMaxSamples = 32768;  // more change the palette's error by less than a hundredth

ColourPoint point_of(const LevelColour& c)
{
    const auto shown = [](float v) { return std::clamp(v, 0.0f, 255.0f); };
    return {shown(c[0]), shown(c[1]), shown(c[2]), 0};
}

std::vector<ColourPoint> centres_for(const std::vector<LevelColour>& texels)
{
    std::vector<ColourPoint> points;
    const size_t stride = texels.size() / kMaxSamples + 1;
    for (size_t k = 0; k < texels.size(); k += stride) points.push_back(point_of(texels[k]));
    std::vector<ColourPoint> centres = k_means(points, {}, detail::format::kPaletteEntries, kTexelPaletteSeed);
    for (ColourPoint& c : centres)
        for (float& v : c) v = std::round(v);
    return centres;
}

// The least squared error of opaque texels, of colours as they can be shown.
PalettedTexels paletted(const std::vector<LevelColour>& texels, const std::vector<LevelColour>& opaque)
{
    const std::vector<ColourPoint> centres = centres_for(opaque);
    PalettedTexels result;
    for (size_t k = 0; k < centres.size(); ++k) {
        const ColourPoint& c = centres[k];
        result.palette[k] = {static_cast<uint8_t>(c[0]), static_cast<uint8_t>(c[1]), static_cast<uint8_t>(c[2])};
    }
    for (const LevelColour& t : texels)
        result.texels.push_back(static_cast<uint8_t>(nearest_centre(centres, point_of(t)).index));
    return result;
}

// The texels that are not see-through.
std::vector<LevelColour> opaque_texels(const FitShape& shape, std::vector<LevelColour> texels)
{
    std::vector<bool> is_opaque(texels.size(), true);
    for (size_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p)
        for (uint32_t k = 0; k < shape.layout.rectangles[p].size(); ++k)
            is_opaque[shape.layout.rectangles[p].begin + k] = false;
    size_t count = 0;
    for (size_t t = 0; t < texels.size(); ++t)
        if (is_opaque[t]) texels[count++] = texels[t];
    texels.resize(count);
    return texels;
}

constexpr int kMostIterations = 60, kIterationsAtOnce = 10;
constexpr double kSolveWork = 60;  // light paths a texel that take as long

TexelLight light_of(const EncodedTone& tone, const TexelSums& sums, const LevelColour& texel)
{
    const double unit = kLevelUnit / std::max(sums.count, 1u);
    LevelColour expected, target, tables;
    float light[3];
    for (size_t c = 0; c < 3; ++c) {
        const double shown = unit * static_cast<double>(sums.target[c]);
        tables[c] = static_cast<float>(shown) - texel[c];
        target[c] = static_cast<float>(shown + unit * static_cast<double>(sums.cut_off[c]));
        light[c] = static_cast<float>(kLightUnit * static_cast<double>(sums.light[c]) / std::max(sums.count, 1u));
        expected[c] = std::min(255.0f, static_cast<float>(unit * static_cast<double>(sums.predicted[c])));
    }
    const Rgb mean = {light[0], light[1], light[2]};
    const double scatter = kScatterUnit / 3 * static_cast<double>(sums.whole_scatter);
    return {tone.line_at(expected), sums.count == 0 ? texel : target, mean, tables, scatter, sums.count};
}

void finish_texels(const FitState& state, FitModel& model)
{
    std::vector<uint32_t> counts(model.texels.size(), 0);  // rectangles do not lie in the order of patches
    for (uint32_t p = 0; p < state.shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = state.shape.layout.rectangles[p];
        const PatchSums& sums = state.sums.patches()[p];
        std::vector<TexelLight> light;
        for (size_t t = 0; t < r.size(); ++t) {
            light.push_back(light_of(state.tone, sums.texels[t], model.texels[r.begin + t]));
            counts[r.begin + t] = sums.texels[t].count;
        }
        const std::vector<LevelColour> texels = finished(state.tone, light, r.n);
        std::copy(texels.begin(), texels.end(), model.texels.begin() + r.begin);
    }
    fill_starved_patches(state.shape, counts, model.texels);
}

class Solution
{
public:
    Solution(const FitState& state, BakeStages& stages, Job& job)
        : state_(state), smoothness_(state.shape), stages_(stages), job_(job)
    {
    }

    // From `model` on. Nodes of vertices that are not `viewed` are 0.
    void solve(FitModel& model, const std::vector<uint8_t>& viewed, const char* name)
    {
        smoothness_.learn(state_.sums, model);
        FitSolver solver(state_.sums, smoothness_, viewed, job_);
        ConjugateGradients gradients;
        for (int done = 0; done < kMostIterations && !gradients.done; done += kIterationsAtOnce) {
            const auto next = [&] {
                ConjugateGradients d = done == 0 ? solver.begun(model) : std::move(gradients);
                solver.advance(d, kIterationsAtOnce);
                return d;
            };
            gradients = stages_.once<ConjugateGradients>(name, next, done);
            stages_.require_shape(is_of(gradients, state_.shape));
        }
        solver.take(gradients, model);
    }
    // The texels that go with these nodes.
    void refit_texels(FitModel& model) const
    {
        FitSolver(state_.sums, smoothness_, {}, job_).fit_texels(model);
        finish_texels(state_, model);
    }

private:
    const FitState& state_;
    ViewSmoothness smoothness_;
    BakeStages& stages_;
    Job& job_;
};

}  // namespace

uint64_t solution_work(const FitShape& shape)
{
    return static_cast<uint64_t>(kSolveWork * shape.layout.texels);
}

FieldParts solved(FitState& state, bool view_tables, const FieldSphere& sphere, BakeStages& stages, Job& job)
{
    const JobStage stage(job, Stage::solving, job.part_of_rest(1), 2 * kMostIterations);
    for_patches(state.shape, job, [&](uint32_t p) { state.sums.patches()[p].pairs.sort(); });
    Solution solution(state, stages, job);
    std::vector<uint8_t> viewed(state.shape.mesh.positions.size(), 0);
    FitModel model = state.expected;
    if (view_tables) {
        solution.solve(model, viewable_vertices(state.shape.mesh), "all tables");
        job.run(1, [&](uint32_t) { viewed = viewed_vertices(state.sums, model); });
    }
    solution.solve(model, viewed, "tables");
    QuantisedViews views;
    job.run(1, [&](uint32_t) {
        const auto count = static_cast<uint32_t>(std::count(viewed.begin(), viewed.end(), 1));
        const uint32_t bits = code_bits_for(planned_view_bytes(state.shape.mesh), count);
        views = quantised(state.sums, model, viewed, bits);
    });
    model.nodes = decoded(views);
    PalettedTexels texels;
    job.run(1, [&](uint32_t) {
        solution.refit_texels(model);
        texels = paletted(model.texels, opaque_texels(state.shape, model.texels));
    });
    FieldParts parts = {sphere.centre, sphere.radius,         texels.palette, std::move(texels.texels),
                        views.colours, std::move(views.views)};
    if (state.shape.mesh.see_through_patches != 0)
        put_see_through(state.shape, state.tone, model.texels, parts.see_through, parts.texels);
    return parts;
}

}  // namespace lumi::baker
