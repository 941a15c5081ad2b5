// SPDX-License-Identifier: MIT
#include "fit/matt_light.h"

#include <catch2/catch.hpp>

#include "math/sampler.h"

namespace lumi::baker::testing
{
namespace
{

// A pilot learns this of a square whose matt light is 0.5 in the mean, with noise, and so much more from the right.
FitModel learnt(float from_right)
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(4, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, 3}};
    const FitShape shape(mesh, {8});
    const PatchRectangle& r = shape.layout.rectangles[0];
    std::vector<FitSample> samples;
    Sampler sampler(1, 0, 0);
    for (uint32_t k = 0; k < 32 * r.size(); ++k) {
        sampler.start(k);
        const Vec2 eye = sampler.next_2d();
        const auto q12 = [](float f) { return static_cast<int16_t>(4096 * f); };
        const float light = sampler.next_1d() + (eye.x > 0.5f ? from_right : -from_right) / 2;
        samples.push_back(
            {0, r.begin + k % r.size(), 0, 0, {q12(4 * eye.x - 2), q12(4 * eye.y - 2), q12(2)}, {}, grey(light)});
    }
    FitModel model = empty_model(shape);
    learn_matt_light(shape, 0, samples.data(), samples.data() + samples.size(), 2, model);
    return model;
}

}  // namespace

TEST_CASE("a pilot learns a texel's mean matt light, and whether views see it alike", "[fit]")
{
    const FitModel same = learnt(0), other = learnt(0.4f);
    for (uint32_t t = 0; t < 16; ++t) CHECK(same.matt[t].g == Approx(0.5).margin(0.25));
    CHECK(same.alike[0] > 0.8f);
    CHECK(other.alike[0] < 0.2f);
}

TEST_CASE("a pilot that met nothing makes no matt light", "[fit]")
{
    PatchMesh mesh;
    mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(3, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 2, PatchMesh::kNone}};
    const FitShape shape(mesh, {4});
    FitModel model = empty_model(shape);
    learn_matt_light(shape, 0, nullptr, nullptr, 2, model);
    for (const Rgb& matt : model.matt) CHECK(max_component(matt) == 0);
    CHECK(model.alike[0] == 1);
}

}  // namespace lumi::baker::testing
