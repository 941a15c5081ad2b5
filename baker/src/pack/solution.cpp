// SPDX-License-Identifier: MIT
#include "pack/solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fit/encoded_tone.h"
#include "fit/fit_model.h"
#include "fit/fit_solver.h"
#include "fit/texel_finish.h"
#include "image/palette.h"
#include "lumi/color.h"
#include "lumi/field_format.h"
#include "pack/surface_writer.h"
#include "pack/view_quantiser.h"

namespace lumi::baker
{

namespace
{

// Packs the light that see-through texels add and let pass into the format's bits.
//
// A path through glass adds light; a display blends encoded levels. So for each texel the line is chosen that shows the
// right levels for about the light behind it, and over the background what a blend with its coverage shows.

constexpr uint64_t kSeeThroughPaletteSeed = 0x73736565;
constexpr size_t kMaxSeeThroughSamples = 32768;
constexpr float kBehindSpread = 30;                        // levels, of the light behind a texel around its mean
constexpr float kBackground = 40, kBackgroundSpread = 60;  // levels that displays have behind objects
constexpr float kBehindStep = 8;                           // levels, for slopes
constexpr float kWhiteLevel = 255;

float shown_level(float v)
{
    return std::clamp(v, 0.0f, kWhiteLevel);
}

Rgb radiance_of(const EncodedTone& tone, const LevelColour& levels)
{
    const Rgb r = tone.line_at(levels).inverse(levels);
    return {std::max(r.r, 0.0f), std::max(r.g, 0.0f), std::max(r.b, 0.0f)};
}

// Sums of a least-squares line, levels over levels behind.
struct LineSums {
    float weight = 0, behind = 0, behind2 = 0, level = 0, product = 0;

    // Weighted samples around a place on a line with this slope.
    void add(float w, float place, float spread, float value, float slope)
    {
        const float spread2 = spread * spread;
        weight += w;
        behind += w * place;
        behind2 += w * (place * place + spread2);
        level += w * value;
        product += w * (place * value + spread2 * slope);
    }
};

// The light that a texel adds, and the share that it lets pass, both 0 .. 255 a channel.
ColourPoint added_and_passed(const SeeThroughTexel& texel, const EncodedTone& tone, const LevelColour& levels)
{
    const float coverage = std::clamp(texel.coverage, 0.0f, 1.0f), clear = 1 - coverage;
    const auto [least, most] = std::minmax({texel.through.r, texel.through.g, texel.through.b});
    const float hue = 1 - least / std::max(most, 1e-6f);
    const auto background = [&](float level) {  // by coverage as a display blends, or coloured as what stands there
        const LevelColour lit = tone.encoded(radiance_of(tone, {level, level, level}) * texel.through);
        const auto channel = [&](size_t c) { return (1 - hue) * clear * level + hue * lit[c]; };
        return LevelColour{channel(0), channel(1), channel(2)};
    };
    const LevelColour back = background(kBackground), brighter = background(kBackground + kBehindStep);
    const float shares[3] = {texel.through.r, texel.through.g, texel.through.b};
    const LevelColour own = {shown_level(levels[0]), shown_level(levels[1]), shown_level(levels[2])};
    const Rgb own_light = radiance_of(tone, own) * coverage;
    const LevelColour behind = tone.encoded(texel.behind);
    const auto through = [&](float step) {
        const LevelColour at = {shown_level(behind[0] + step), shown_level(behind[1] + step),
                                shown_level(behind[2] + step)};
        return tone.encoded(own_light + radiance_of(tone, at) * texel.through);
    };
    const LevelColour here = through(0), above = through(kBehindStep), below = through(-kBehindStep);
    ColourPoint result{};
    for (size_t c = 0; c < 3; ++c) {
        const float place = shown_level(behind[c]),
                    width = shown_level(behind[c] + kBehindStep) - shown_level(behind[c] - kBehindStep);
        const float slope = width > 0 ? (above[c] - below[c]) / width : shares[c];
        LineSums s;
        s.add(std::max(1 - texel.open, 1e-3f), place, kBehindSpread, here[c], slope);
        s.add(std::max(texel.open, 1e-3f), kBackground, kBackgroundSpread, coverage * own[c] + back[c],
              (brighter[c] - back[c]) / kBehindStep);
        const float rise = s.product - s.behind * s.level / s.weight, run = s.behind2 - s.behind * s.behind / s.weight;
        const float passed = std::clamp(rise / run, 0.0f, 1.0f);
        result[c] = shown_level((s.level - passed * s.behind) / s.weight);
        result[c + 3] = kWhiteLevel * passed;
    }
    return result;
}

uint8_t level_byte(float v)
{
    return static_cast<uint8_t>(std::lround(shown_level(v)));
}

// Sets the palette but for its last entries, and those of the texels that are see-through. `levels`: what the surface
// itself shows, by texel.
void put_see_through(const FitShape& shape, const EncodedTone& tone, const std::vector<LevelColour>& levels,
                     size_t kept, FieldParts& parts)
{
    std::vector<uint32_t> places;
    std::vector<ColourPoint> points;
    for (size_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) {
            places.push_back(t);
            points.push_back(added_and_passed(shape.see_through[t], tone, levels[t]));
        }
    }
    std::vector<ColourPoint> some;
    for (size_t k = 0; k < points.size(); k += points.size() / kMaxSeeThroughSamples + 1) some.push_back(points[k]);
    const std::vector<ColourPoint> centres = k_means(some, {}, parts.see_through.size() - kept, kSeeThroughPaletteSeed);
    for (size_t k = 0; k < centres.size(); ++k) {
        const ColourPoint& c = centres[k];
        parts.see_through[k] = {{level_byte(c[0]), level_byte(c[1]), level_byte(c[2])},
                                {level_byte(c[3]), level_byte(c[4]), level_byte(c[5])}};
    }
    for (size_t k = 0; k < points.size(); ++k)
        parts.texels[places[k]] = static_cast<uint8_t>(nearest_centre(centres, points[k]).index);
}

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
            gain = static_cast<uint8_t>(std::max(std::lround(share * static_cast<float>(gain)), 1L));
    }
}

struct PalettedTexels {
    std::array<Rgb8, detail::format::kPaletteEntries> palette{};
    std::vector<uint8_t> texels;
};

constexpr uint64_t kTexelPaletteSeed = 0x73706C;
constexpr size_t kMaxSamples = 32768;  // more change the palette's error by less than a hundredth

ColourPoint point_of(const LevelColour& c)
{
    const auto shown = [](float v) { return std::clamp(v, 0.0f, 255.0f); };
    return {shown(c[0]), shown(c[1]), shown(c[2])};
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

FieldParts solved(FitState& state, const FieldSphere& sphere, BakeStages& stages, Job& job, size_t kept)
{
    const JobStage stage(job, Stage::solving, job.part_of_rest(1), 2 * kMostIterations);
    for_patches(state.shape, job, [&](uint32_t p) { state.sums.patches()[p].pairs.sort(); });
    state.sums.weigh(state.lines);
    Solution solution(state, stages, job);
    FitModel model = state.expected;
    solution.solve(model, "all tables");
    job.run(1, [&](uint32_t) { model.viewed = viewed_vertices(state.sums, model, kLeastDifference); });
    solution.solve(model, "tables");
    QuantisedViews views;
    job.run(1, [&](uint32_t) {
        const auto count = static_cast<uint32_t>(std::count(model.viewed.begin(), model.viewed.end(), 1));
        const uint32_t bits = code_bits_for(planned_view_bytes(state.shape.mesh), count);
        views = quantised(state.sums, model, model.viewed, bits);
    });
    model.nodes = decoded(views);
    PalettedTexels texels;
    job.run(1, [&](uint32_t) {
        solution.refit_texels(model);
        texels = paletted(model.texels, opaque_texels(state.shape, model.texels));
    });
    cover_views(state.shape, views.views);
    FieldParts parts = {sphere.centre, sphere.radius,         texels.palette, std::move(texels.texels),
                        views.colours, std::move(views.views)};
    if (state.shape.mesh.see_through_patches != 0) put_see_through(state.shape, state.tone, model.texels, kept, parts);
    return parts;
}

}  // namespace lumi::baker
