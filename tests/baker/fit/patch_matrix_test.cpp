// SPDX-License-Identifier: MIT
#include "fit/patch_matrix.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"

namespace lumi::baker::testing
{
namespace
{

FitShape four_texels()
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(4, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, 3}};
    return FitShape(mesh, {2});
}

// Light paths from all sides to all of it.
std::vector<FitSample> paths_from_all_sides(const FitShape& shape)
{
    const auto q12 = [](float v) { return static_cast<int16_t>(v * kEyeScale); };
    std::vector<FitSample> samples;
    Sampler sampler(1, 0, 0);
    for (uint32_t k = 0; k < 200; ++k) {
        sampler.start(k);
        const Vec2 place = sampler.next_2d(), eye = sampler.next_2d();
        samples.push_back({k % 2,
                           shape.layout.rectangles[0].begin + k % 4,
                           q12(place.x / 2),
                           q12(place.y / 2),
                           {q12(4 * eye.x - 2), q12(4 * eye.y - 2), q12(2)},
                           grey(0.5f),
                           {}});
    }
    return samples;
}

// The sum of squares of what nodes add to each path, less its mean over the texel.
double squares(const FitShape& shape, const std::vector<FitSample>& samples, const std::vector<double>& nodes)
{
    std::array<double, 4> sums{}, all{};
    std::array<int, 4> counts{};
    for (const FitSample& s : samples) {
        double shown = 0;
        const SampleTaps taps = taps_of(shape, s, empty_model(shape).viewed);
        for (uint32_t k = 0; k < taps.count; ++k)
            shown += kWeightUnit * taps.taps[k].weight_q12 * nodes[3 * size_t{taps.taps[k].node}];
        const size_t t = s.texel - shape.layout.rectangles[0].begin;
        sums[t] += shown;
        all[t] += shown * shown;
        ++counts[t];
    }
    double result = 0;
    for (size_t t = 0; t < 4; ++t) result += all[t] - sums[t] * sums[t] / counts[t];
    return result;
}

}  // namespace

TEST_CASE("a patch's matrix gives the squares that are left once texels have taken their means", "[fit]")
{
    const FitShape shape = four_texels();
    REQUIRE(shape.layout.rectangles[0].size() == 4);
    const std::vector<FitSample> samples = paths_from_all_sides(shape);
    const EncodedTone tone(ToneCurve::srgb);
    const FitModel expected = empty_model(shape);
    FitSums sums(shape, tone, expected, White::goes_on);
    sums.add(0, samples.data(), samples.data() + samples.size());
    const PatchMatrix matrix(sums.patches()[0]);
    std::vector<double> nodes(3 * kPatchNodes), product(3 * kPatchNodes);
    Sampler sampler(2, 0, 0);
    for (size_t k = 0; k < nodes.size(); k += 3) {
        sampler.start(static_cast<uint32_t>(k));
        nodes[k] = static_cast<double>(sampler.next_1d()) - 0.5;
    }
    matrix.add_product(nodes, product);
    double got = 0;
    for (size_t k = 0; k < nodes.size(); ++k) got += nodes[k] * product[k];
    CHECK(got == Approx(squares(shape, samples, nodes)).epsilon(1e-5));

    std::vector<float> diagonal(kPatchNodes);
    matrix.each([&](uint32_t a, uint32_t b, float number) {
        if (a == b) diagonal[a] += number;
    });
    for (size_t k = 0; k < kPatchNodes; ++k) {
        std::vector<double> one(nodes.size());
        one[3 * k] = 1;
        CHECK(diagonal[k] == Approx(squares(shape, samples, one)).margin(1e-5));
    }
}

}  // namespace lumi::baker::testing
