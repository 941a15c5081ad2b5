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
PatchSums sums_of(const Rgb& radiance, bool diffuse)
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(4, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, 3}};
    const FitShape shape(mesh, {1});
    const EncodedTone tone(ToneCurve::srgb);
    FitModel expected = empty_model(shape);
    for (LevelColour& texel : expected.texels) texel = {120, 120, 120};
    FitSums sums(shape, tone, expected, White::clips);
    const FitSample sample = {0, shape.layout.rectangles[0].begin, 0, 0, {0, 0, 2 * 4096}, radiance, diffuse};
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
    const ToneLine line = EncodedTone(ToneCurve::srgb).line_at({120, 120, 120});
    for (const bool diffuse : {false, true}) {
        const PatchSums sums = sums_of(bright, diffuse);
        const TexelSums& texel = sums.texels[0];
        const double red = levels(texel.target[0]) - 120;
        CHECK(red < 1000);
        CHECK(red > 255);  // so white stays in reach, whatever is expected
        for (size_t c = 0; c < 3; ++c) {
            const double whole = static_cast<double>(line(bright)[c]), target = levels(texel.target[c]);
            CHECK((target - 120) / red ==
                  Approx((whole - 120) / static_cast<double>(line(bright)[0] - 120)).epsilon(1e-3));
            CHECK(levels(texel.cut_off[c]) == Approx(diffuse ? whole - target : 0).margin(0.1));
            int64_t at_nodes = 0;  // of weights that are 1 together
            for (const std::array<int64_t, 3>& node : sums.targets) at_nodes += node[c];
            CHECK(kWeightUnit * levels(at_nodes) == Approx(target).epsilon(0.01));
        }
    }
}

TEST_CASE("sums take other paths whole", "[fit]")
{
    const Rgb grey = {0.5f, 0.2f, 1};
    const PatchSums sums = sums_of(grey, true);
    const LevelColour whole = EncodedTone(ToneCurve::srgb).line_at({120, 120, 120})(grey);
    for (size_t c = 0; c < 3; ++c) {
        CHECK(levels(sums.texels[0].target[c]) == Approx(whole[c]).margin(0.02));
        CHECK(sums.texels[0].cut_off[c] == 0);
    }
    CHECK(sums.texels[0].scatter == sums.texels[0].whole_scatter);
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
