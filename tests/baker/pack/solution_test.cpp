// SPDX-License-Identifier: MIT
#include "pack/solution.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"
#include "support/brute_force.h"

namespace lumi::baker::testing
{
namespace
{

constexpr uint32_t kSquares = 4, kCoarse = 0, kUnmet = 1;

// Side by side. One has fewer texels, so that its rectangle does not lie first.
FitShape squares_in_a_row()
{
    PatchMesh mesh;
    for (uint32_t k = 0; k <= kSquares; ++k) {
        const float x = 0.1f * static_cast<float>(k) - 0.2f;
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x, 0.1f, 0}});
    }
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    for (uint32_t k = 0; k < kSquares; ++k) mesh.patches.push_back({2 * k, 2 * k + 2, 2 * k + 1, 2 * k + 3});
    mesh.longest_edge = 0.15f;
    std::vector<float> densities(kSquares, 60);
    densities[kCoarse] = 20;
    return FitShape(std::move(mesh), densities);
}

// Paths to all texels of a patch, of one radiance, all of it matt.
std::vector<FitSample> paths_to(const FitShape& shape, uint32_t patch, const Rgb& radiance)
{
    constexpr uint32_t kPaths = 4000;
    const auto q12 = [](float f) { return static_cast<int16_t>(4096 * f); };
    Sampler sampler(7, 0, 0);
    std::vector<FitSample> samples;
    for (uint32_t k = 0; k < kPaths; ++k) {
        sampler.start(kPaths * patch + k);
        const Vec2 place = sampler.next_2d(), eye = sampler.next_2d();
        const float second = place.x * (1 - place.y), third = place.y;
        const bool second_triangle = k % 2 != 0;
        samples.push_back({2 * patch + (second_triangle ? 1u : 0u),
                           texel_at(shape.layout.rectangles[patch], second_triangle, second, third),
                           q12(second),
                           q12(third),
                           {q12(4 * eye.x - 2), q12(4 * eye.y - 2), q12(2)},
                           radiance,
                           radiance});
    }
    return samples;
}

// Without tables, after a pilot that drew as many lines to each texel.
void skip_pilot(FitState& state)
{
    state.lines.assign(kSquares, 1);
    state.expected.viewed.assign(state.expected.viewed.size(), 0);
    state.expected.alike.assign(kSquares, 1);
    state.has_pilot = true;
}

// The mean red of texels, where one path of eleven is bright, as kept sums of such paths show them.
double mean_shown(bool is_matt)
{
    constexpr uint32_t kRarity = 11;
    const FitShape shape = squares_in_a_row();
    const EncodedTone tone(ToneCurve::srgb);
    FitState state(shape, tone), kept(shape, tone);
    skip_pilot(state);
    for (LevelColour& texel : state.expected.texels) texel = tone.encoded({0.1f, 0.1f, 0.1f});
    for (Rgb& matt : state.expected.matt) matt = is_matt ? grey(0.1f) : Rgb();
    for (uint32_t p = 0; p < kSquares; ++p) {
        std::vector<FitSample> samples = paths_to(shape, p, {0.1f, 0.1f, 0.1f});
        for (size_t k = 0; k < samples.size(); ++k) {
            if (k % kRarity == 0) samples[k].radiance = {4, 4, 4};
            samples[k].matt = is_matt ? samples[k].radiance : Rgb();
        }
        state.sums.add(p, samples.data(), samples.data() + samples.size());
    }
    REQUIRE(add_encoded(encode(state), kept));
    Job job(solution_work(kept), 1, {});
    BakeStages stages({}, {});
    const FieldParts parts = solved({{kept, stages}}, {{0, 0, 0}, 1}, job);
    Mean mean;
    for (const PatchRectangle& r : shape.layout.rectangles)
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) mean.add(parts.palette[parts.texels[t]].r);
    return mean.value();
}

}  // namespace

TEST_CASE("rare bright light is whole in texels where all sides see it, and cut where few do", "[surface]")
{
    CHECK(mean_shown(true) == Approx(180).margin(5));   // (10 · 0.1 + 4)/11, encoded
    CHECK(mean_shown(false) == Approx(131).margin(5));  // the same, the bright paths 600 levels off
}

TEST_CASE("a patch that no path met takes the colour around it, wherever its texels lie", "[surface]")
{
    const FitShape shape = squares_in_a_row();
    REQUIRE(shape.layout.rectangles[kCoarse].begin > shape.layout.rectangles[kUnmet].begin);
    const EncodedTone tone(ToneCurve::srgb);
    FitState state(shape, tone);
    skip_pilot(state);
    for (uint32_t p = 0; p < kSquares; ++p) {
        if (p == kUnmet) continue;
        const std::vector<FitSample> samples = paths_to(shape, p, {0.5f, 0.5f, 0.5f});
        state.sums.add(p, samples.data(), samples.data() + samples.size());
    }
    Job job(solution_work(state), 1, {});
    BakeStages stages({}, {});
    const FieldParts parts = solved({{state, stages}}, {{0, 0, 0}, 1}, job);
    for (uint32_t p = 0; p < kSquares; ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t)
            CHECK(parts.palette[parts.texels[t]].r == Approx(188).margin(3));
    }
}

}  // namespace lumi::baker::testing
