// SPDX-License-Identifier: MIT
#include "fit/view_smoothness.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

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

// Returns what paths teach, where nodes that none of them saw are `unseen`.
ViewSmoothness learnt(float shine, float unseen = 0)
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
    const std::vector<double> seen = node_weights(sums);
    REQUIRE(std::count(seen.begin(), seen.end(), 0.0) > 0);
    for (size_t k = 0; k < seen.size(); ++k)
        if (seen[k] == 0) model.nodes[k] = {unseen, unseen, unseen};
    smoothness.learn(sums, model);
    return smoothness;
}

// The most paths that the expectation of a node is worth.
float node_worth(const ViewSmoothness& smoothness)
{
    std::map<uint32_t, float> diagonal;
    smoothness.each([&](uint32_t a, uint32_t b, float number) {
        if (a == b) diagonal[a] += number;
    });
    float most = 0;
    for (const auto& [node, number] : diagonal) most = std::max(most, number);
    return most;
}

// So many is the difference of two directions worth: its product alone is negative at one vertex.
float direction_worth(const ViewSmoothness& smoothness)
{
    using detail::format::kViewNodes;
    float most = 0;
    smoothness.each([&](uint32_t a, uint32_t b, float number) {
        if (a != b && a / kViewNodes == b / kViewNodes) most = std::max(most, -number);
    });
    return most;
}

}  // namespace

TEST_CASE("tables of a matt surface are learnt to be flat, those of one that shines are not")
{
    const float matt = node_worth(learnt(0)), shining = node_worth(learnt(0.5f));
    CAPTURE(matt, shining);
    CHECK(matt > 4 * shining);
}

TEST_CASE("a direction that no path saw teaches nothing of how alike directions are")
{
    const float usual = direction_worth(learnt(0.2f));
    CHECK(usual > 0);
    CHECK(direction_worth(learnt(0.2f, 500)) == usual);
}

TEST_CASE("each direction of a table is like three others at least")
{
    using detail::format::kViewNodes;
    std::map<uint32_t, int> likes;
    ViewSmoothness(square(), {1, 0, 0, 0}).each([&](uint32_t a, uint32_t b, float number) {
        if (a < kViewNodes && b < kViewNodes && a != b && number < 0) ++likes[a];
    });
    CHECK(likes.size() == kViewNodes);
    for (const auto& [node, count] : likes) CHECK(count >= 3);
}

TEST_CASE("vertices without a view table have nodes of 0, the others keep theirs")
{
    using detail::format::kViewNodes;
    FitModel model = empty_model(square());
    std::fill(model.nodes.begin(), model.nodes.end(), LevelColour{1, 2, 3});
    model.viewed = {0, 1, 1, 0};
    flatten_unviewed(model);
    for (size_t k = 0; k < model.nodes.size(); ++k)
        CHECK((model.nodes[k] == LevelColour{} || model.viewed[k / kViewNodes] != 0));
    CHECK(std::count(model.nodes.begin(), model.nodes.end(), LevelColour{}) == 2 * kViewNodes);
}

TEST_CASE("a solution is advanced by so many iterations, and no more once it is done")
{
    const FitShape shape = square();
    const EncodedTone tone(ToneCurve::srgb);
    FitModel model = empty_model(shape);
    for (LevelColour& texel : model.texels) texel = {130, 130, 130};
    const FitModel expected = model;
    FitSums sums(shape, tone, expected, White::goes_on);
    const std::vector<FitSample> samples = paths(shape, 0.5f);
    sums.add(0, samples.data(), samples.data() + samples.size());
    const ViewSmoothness smoothness(shape, model.viewed);
    Job job(1, 1, {});
    FitSolver solver(sums, smoothness, {}, job);
    ConjugateGradients d = solver.begun(model);
    solver.advance(d, 1);
    CHECK_FALSE(d.done);
    solver.advance(d, 1000);
    REQUIRE(d.done);
    const std::vector<double> solution = d.x;
    solver.advance(d, 1);
    CHECK(d.x == solution);
}

}  // namespace lumi::baker::testing
