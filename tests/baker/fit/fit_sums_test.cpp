// SPDX-License-Identifier: MIT
#include "fit/fit_sums.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

namespace lumi::baker::testing
{
namespace
{

// A square of one texel, of which 120 levels are expected everywhere, and what one path to it adds.
PatchSums sums_of(const Rgb& radiance, const Rgb& matt, const Rgb& mean_matt)
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(4, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, 3}};
    const FitShape shape(mesh, {1});
    const EncodedTone tone(ToneCurve::srgb);
    FitModel expected = empty_model(shape);
    for (LevelColour& texel : expected.texels) texel = {120, 120, 120};
    for (Rgb& mean : expected.matt) mean = mean_matt;
    expected.alike = {1};
    FitSums sums(shape, tone, expected, White::clips);
    const FitSample sample = {0, shape.layout.rectangles[0].begin, 0, 0, {0, 0, 2 * 4096}, radiance, matt};
    sums.add(0, &sample, &sample + 1);
    return sums.patches()[0];
}

double levels(int64_t sum)
{
    return kLevelUnit * static_cast<double>(sum);
}

}  // namespace

TEST_CASE("sums cut a bright path near what is expected, of its own hue", "[fit]")
{
    const Rgb bright = {40, 26, 12};
    const LevelColour whole = EncodedTone(ToneCurve::srgb).line_at({120, 120, 120})(bright);
    const PatchSums sums = sums_of(bright, {}, {});
    const TexelSums& texel = sums.texels[0];
    const double red = levels(texel.target[0]) - 120;
    CHECK(red < 1000);
    CHECK(red > 255);  // so white stays in reach, whatever is expected
    for (size_t c = 0; c < 3; ++c) {
        const double target = levels(texel.target[c]);
        CHECK((target - 120) / red == Approx((whole[c] - 120) / (whole[0] - 120)).epsilon(1e-3));
        CHECK(texel.cut_off[c] == 0);
        int64_t at_nodes = 0;  // of weights that are 1 together
        for (const std::array<int64_t, 3>& node : sums.targets) at_nodes += node[c];
        CHECK(kWeightUnit * levels(at_nodes) == Approx(target).epsilon(0.01));
    }
}

TEST_CASE("sums fit tables to light less its matt part, whose mean counts instead, and keep the whole", "[fit]")
{
    const Rgb light = {40.5f, 26.2f, 13}, matt = {40, 26, 12}, mean = {0.1f, 0.2f, 0.3f};
    const ToneLine line = EncodedTone(ToneCurve::srgb).line_at({120, 120, 120});
    const LevelColour calm = line(light - matt + mean), whole = line(light);
    const PatchSums sums = sums_of(light, matt, mean);
    const TexelSums& texel = sums.texels[0];
    for (size_t c = 0; c < 3; ++c) {
        CHECK(levels(texel.target[c]) == Approx(calm[c]).margin(0.05));
        CHECK(levels(texel.target[c] + texel.cut_off[c]) == Approx(whole[c]).margin(0.05));
    }
    CHECK(texel.scatter < texel.whole_scatter);
}

TEST_CASE("sums take other paths whole", "[fit]")
{
    const Rgb grey = {0.5f, 0.2f, 1};
    const PatchSums sums = sums_of(grey, {}, {});
    const LevelColour whole = EncodedTone(ToneCurve::srgb).line_at({120, 120, 120})(grey);
    for (size_t c = 0; c < 3; ++c) {
        CHECK(levels(sums.texels[0].target[c]) == Approx(whole[c]).margin(0.02));
        CHECK(sums.texels[0].cut_off[c] == 0);
    }
    CHECK(sums.texels[0].scatter == sums.texels[0].whole_scatter);
}

TEST_CASE("a patch's paths weigh as much as the area that each stands for", "[fit]")
{
    PatchMesh mesh;  // two squares, of which one is four times as large, and a triangle of half a square
    mesh.positions = {{0, 0, 0},    {0.2f, 0, 0},    {0, 0.2f, 0},    {0.2f, 0.2f, 0},
                      {0, 0, 0.5f}, {0.1f, 0, 0.5f}, {0, 0.1f, 0.5f}, {0.1f, 0.1f, 0.5f}};
    mesh.normals = std::vector<Vec3>(8, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, 3}, {4, 5, 6, 7}, {4, 5, 6, PatchMesh::kNone}};
    const FitShape shape(mesh, {10, 10, 10});
    const EncodedTone tone(ToneCurve::srgb);
    const FitModel expected = empty_model(shape);
    FitSums sums(shape, tone, expected, White::clips);
    sums.weigh({10, 20, 10});
    double paths = 0, weighed = 0;
    for (uint32_t p = 0; p < 3; ++p) {
        const double drawn = (p == 1 ? 20.0 : 10.0) * shape.layout.rectangles[p].size();
        const double covered = p == 0 ? 0.04 : 0.01;  // half of a triangle's texels lie beyond it
        CHECK(sums.patches()[p].weight * drawn / covered ==
              Approx(sums.patches()[0].weight * 10 * shape.layout.rectangles[0].size() / 0.04));
        paths += drawn;
        weighed += sums.patches()[p].weight * drawn;
    }
    CHECK(weighed == Approx(paths));
}

TEST_CASE("sums of node pairs do not depend on the order of what is added")
{
    std::vector<std::array<uint16_t, 2>> added;
    Sampler sampler(1, 0, 0);
    for (uint32_t k = 0; k < 20000; ++k) {
        sampler.start(k);
        const auto node = [&] { return static_cast<uint16_t>(sampler.next_1d() * static_cast<float>(kPatchNodes)); };
        const uint16_t a = node();
        added.push_back({a, node()});
    }
    std::map<std::pair<uint32_t, uint32_t>, int64_t> truth;
    NodePairs forwards, backwards;
    for (const auto& [a, b] : added) {
        truth[{std::min(a, b), std::max(a, b)}] += a + 2 * b;
        forwards.add(a, b, a + 2 * b);
    }
    std::reverse(added.begin(), added.end());
    for (const auto& [a, b] : added) backwards.add(b, a, a + 2 * b);
    forwards.sort();
    backwards.sort();
    std::vector<std::array<int64_t, 3>> first, second;
    forwards.each([&](uint32_t a, uint32_t b, int64_t sum) {
        CHECK(truth[{a, b}] == sum);
        first.push_back({a, b, sum});
    });
    backwards.each([&](uint32_t a, uint32_t b, int64_t sum) { second.push_back({a, b, sum}); });
    CHECK(first.size() == truth.size());
    CHECK(first == second);
}

}  // namespace lumi::baker::testing
