// SPDX-License-Identifier: MIT
#include "fit/extra_lines.h"

#include <catch2/catch.hpp>

#include "fit/path_plan.h"
#include "support/shapes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

// A glowing pit: few lines get to its floor.
Scene pit()
{
    SceneMaker maker;
    const uint32_t wall = maker.add(lamp(grey(0.4f)));
    const float r = 0.25f, top = 0.9f, bottom = -0.3f;
    maker.quad(wall, {-r, -r, bottom}, {r, -r, bottom}, {r, r, bottom}, {-r, r, bottom});
    maker.quad(wall, {-r, -r, bottom}, {-r, r, bottom}, {-r, r, top}, {-r, -r, top});
    maker.quad(wall, {r, r, bottom}, {r, -r, bottom}, {r, -r, top}, {r, r, top});
    maker.quad(wall, {r, -r, bottom}, {-r, -r, bottom}, {-r, -r, top}, {r, -r, top});
    maker.quad(wall, {-r, r, bottom}, {r, r, bottom}, {r, r, top}, {-r, r, top});
    maker.span_unit_sphere();
    return maker.make(constant_environment(0));
}

uint32_t floor_of(const PatchMesh& mesh)
{
    for (uint32_t p = 0; p < mesh.patches.size(); ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        const Vec3 &a = mesh.positions[patch.a], &b = mesh.positions[patch.b], &c = mesh.positions[patch.c];
        if (normalized(cross(b - a, c - a)).z > 0.99f) return p;
    }
    FAIL("there is no floor");
    return 0;
}

// Means over the lines that meet a patch.
struct Meetings {
    uint32_t count = 0;
    double side = 0, height = 0, second = 0, third = 0;
};

Meetings meetings(const SampleTracer& tracer, uint32_t patch, const ExtraLines* extra)
{
    constexpr uint32_t kBatches = 200;
    Meetings m;
    for (uint32_t k = 0; k < kBatches; ++k) {
        for (const FitSample& s : tracer.samples(1, k, extra)) {
            if (s.triangle / 2 != patch) continue;
            ++m.count;
            m.side += std::abs(s.eye.x) / 4096.0;
            m.height += s.eye.z / 4096.0;
            m.second += s.second_q12 / 4096.0;
            m.third += s.third_q12 / 4096.0;
        }
    }
    for (double* mean : {&m.side, &m.height, &m.second, &m.third}) *mean /= m.count;
    return m;
}

// Two squares side by side.
FitShape squares()
{
    PatchMesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0}, {0, -0.5f, 0}, {0.5f, -0.5f, 0},
                      {-0.5f, 0.5f, 0},  {0, 0.5f, 0},  {0.5f, 0.5f, 0}};
    mesh.normals = std::vector<Vec3>(6, Vec3{0, 0, 1});
    mesh.patches = {{0, 1, 3, 4}, {1, 2, 4, 5}};
    return FitShape(mesh, {8, 8});
}

// Light of levels that differ by up to `noise`, in each texel of a patch.
void add_light(FitSums& sums, uint32_t patch, uint32_t paths_a_texel, float noise)
{
    const PatchRectangle& r = sums.shape().layout.rectangles[patch];
    std::vector<FitSample> samples;
    Sampler sampler(1, patch, 0);
    for (uint32_t k = 0; k < paths_a_texel * r.size(); ++k) {
        sampler.start(k);
        const float light = 0.2f + noise * (sampler.next_1d() - 0.5f);
        samples.push_back({2 * patch, r.begin + k % r.size(), 1000, 1000, {0, 0, 12288}, {light, light, light}, true});
    }
    sums.add(patch, samples.data(), samples.data() + samples.size());
}

std::vector<float> chances_of(uint32_t first_paths, float first_noise)
{
    const FitShape shape = squares();
    const EncodedTone tone(ToneCurve::srgb);
    FitModel model = empty_model(shape);
    for (LevelColour& texel : model.texels) texel = {124, 124, 124};
    FitSums sums(shape, tone, model, White::goes_on);
    add_light(sums, 0, first_paths, first_noise);
    add_light(sums, 1, 40, 0.1f);
    return extra_chances(sums, 10000, 0.25);
}

}  // namespace

TEST_CASE("Extra lines bring more light paths to a patch and do not change where these come from", "[fit]")
{
    const Scene scene = pit();
    const PatchMesh mesh = built_mesh(scene, {12, 2, 0.7f}).mesh;
    const FitShape shape(mesh, std::vector<float>(mesh.patches.size(), 6));
    const uint32_t floor = floor_of(mesh);
    std::vector<float> chances(mesh.patches.size(), 0);
    chances[floor] = 1;
    const ExtraLines extra(shape, chances);
    const SampleTracer tracer(scene.data(), shape);
    const Meetings without = meetings(tracer, floor, nullptr), with = meetings(tracer, floor, &extra);
    CAPTURE(without.count, with.count);
    CHECK(without.count > 500);
    CHECK(with.count > 5 * without.count);
    CHECK(with.side == Approx(without.side).margin(0.05));
    CHECK(with.height == Approx(without.height).margin(0.02));
    CHECK(with.second == Approx(without.second).margin(0.02));
    CHECK(with.third == Approx(without.third).margin(0.02));
}

TEST_CASE("Extra lines go where light is noisy or few lines come", "[fit]")
{
    const std::vector<float> alike = chances_of(40, 0.1f), noisy = chances_of(40, 0.3f), starved = chances_of(4, 0.1f);
    CHECK(alike[0] == Approx(0.5f).margin(0.1));
    CHECK(noisy[0] > 0.95f);
    CHECK(starved[0] > 0.95f);
    for (const std::vector<float>& chances : {alike, noisy, starved}) CHECK(chances[0] + chances[1] == Approx(1));
}

TEST_CASE("Where no light was met, no extra line is drawn", "[fit]")
{
    const FitShape shape = squares();
    const EncodedTone tone(ToneCurve::srgb);
    const FitModel model = empty_model(shape);
    CHECK(extra_chances(FitSums(shape, tone, model, White::goes_on), 10000, 0.25).empty());
    CHECK(ExtraLines(shape, {}).empty());
}

}  // namespace lumi::baker::testing
