// SPDX-License-Identifier: MIT
#include "fit/view_smoothness.h"

#include <catch2/catch.hpp>

#include "fit/fit_solver.h"

namespace lumi::baker::testing
{
namespace
{

// One square, seen from in front.
FitShape square()
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(4, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, 3}};
    return FitShape(mesh, {4});
}

// Light paths that meet the square, from eyes all around; `shine` is how much more light goes to the right.
std::vector<FitSample> paths(const FitShape& shape, float shine)
{
    constexpr uint32_t kPaths = 20000;
    std::vector<FitSample> samples;
    Sampler sampler(1, 0, 0);
    for (uint32_t k = 0; k < kPaths; ++k) {
        sampler.start(k);
        const Vec2 place = sampler.next_2d(), eye = sampler.next_2d();
        const bool is_second = place.x + place.y > 1;
        const float u = is_second ? 1 - place.x : place.x, v = is_second ? 1 - place.y : place.y;
        const float x = 4 * eye.x - 2, light = 0.2f + 0.1f * sampler.next_1d() + (x > 0.8f ? shine : 0);
        const auto q12 = [](float f) { return static_cast<int16_t>(4096 * f); };
        samples.push_back({is_second ? 1u : 0u,
                           texel_at(shape.layout.rectangles[0], is_second, u, v),
                           q12(u),
                           q12(v),
                           {q12(x), q12(4 * eye.y - 2), q12(2)},
                           Rgb{light, light, light},
                           {}});
    }
    return samples;
}

// The most paths that the expectation of a node is worth, once it has been learnt.
float learnt_worth(float shine)
{
    const FitShape shape = square();
    const EncodedTone tone(ToneCurve::srgb);
    FitModel model = empty_model(shape);
    for (LevelColour& texel : model.texels) texel = {130, 130, 130};
    const FitModel expected = model;
    FitSums sums(shape, tone, expected, White::goes_on);
    const std::vector<FitSample> samples = paths(shape, shine);
    sums.add(0, samples.data(), samples.data() + samples.size());
    ViewSmoothness smoothness(shape, model.viewed);
    Job job(1, 1, {});
    FitSolver(sums, smoothness, {}, job).solve(model, 20);
    smoothness.learn(sums, model);
    std::vector<float> diagonal(model.nodes.size());
    smoothness.each([&](uint32_t a, uint32_t b, float number) {
        if (a == b) diagonal[a] += number;
    });
    return *std::max_element(diagonal.begin(), diagonal.end());
}

}  // namespace

TEST_CASE("tables of a matt surface are learnt to be flat, those of one that shines are not")
{
    const float matt = learnt_worth(0), shining = learnt_worth(0.5f);
    CAPTURE(matt, shining);
    CHECK(matt > 4 * shining);
}

}  // namespace lumi::baker::testing
