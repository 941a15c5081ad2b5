// SPDX-License-Identifier: MIT
// The path tracer and brute force agree within their confidence intervals on every kind of scene.
#include <catch2/catch.hpp>

#include "image/radiance_picture.h"
#include "support/brute_force.h"
#include "support/volumes.h"

namespace lumi::baker
{
namespace
{

using testing::add_room;
using testing::BruteForce;
using testing::kSigmas;
using testing::Mean;
using testing::radiance;
using testing::SceneMaker;

void check_integrators_agree(const Scene& scene, uint32_t brute_paths)
{
    constexpr uint32_t kRays = 24;
    const std::vector<Mean> ours = radiance(PathTracer(scene.data()), brute_paths / 4, kRays, 31);
    const std::vector<Mean> brute = radiance(BruteForce(scene.data()), brute_paths, kRays, 32);
    double chi2 = 0, total = 0, brute_total = 0;
    for (uint32_t r = 0; r < kRays; ++r) {
        const double error = std::hypot(ours[r].error(), brute[r].error());
        INFO("ray " << r << ": " << ours[r].value() << " and " << brute[r].value() << " ± " << error);
        CHECK(std::abs(ours[r].value() - brute[r].value()) <= kSigmas * error + 1e-6);
        if (error > 0) {
            const double score = (ours[r].value() - brute[r].value()) / error;
            chi2 += score * score;
        }
        total += ours[r].value();
        brute_total += brute[r].value();
    }
    INFO("sums " << total << " and " << brute_total);
    CHECK(chi2 < kRays + kSigmas * std::sqrt(2.0 * kRays));
    CHECK(total > 0);
}

}  // namespace

TEST_CASE("agreement: the path tracer agrees with brute force on diffuse and glossy bodies under a lamp")
{
    SceneMaker maker;
    add_room(maker);
    maker.ball(maker.add(testing::glossy({0.2f, 0.4f, 0.6f}, 0.2f)), {0.2f, 0, -0.3f}, 0.2f, 8);
    maker.ball(maker.add(testing::metal({0.9f, 0.7f, 0.3f}, 0.3f)), {-0.2f, 0, -0.25f}, 0.22f, 8);
    check_integrators_agree(maker.make(constant_environment(0)), 4000);
}

TEST_CASE("agreement: the path tracer agrees with brute force under a gradient sky with a lamp")
{
    SceneMaker maker;
    add_room(maker);
    maker.ball(maker.add(testing::metal({0.9f, 0.7f, 0.3f}, 0.05f)), {0, 0, -0.2f}, 0.25f, 8);
    check_integrators_agree(maker.make(gradient_environment()), 3000);
}

TEST_CASE("agreement: the path tracer agrees with brute force through a thin pane and with partly metallic paint")
{
    SceneMaker maker;
    add_room(maker);
    Material pane = testing::diffuse({0.3f, 0.5f, 0.3f});
    pane.opacity = 0.4f;
    maker.quad(maker.add(pane), {-0.4f, -0.3f, -0.4f}, {0.4f, -0.3f, -0.4f}, {0.4f, -0.3f, 0.4f}, {-0.4f, -0.3f, 0.4f});
    maker.quad(maker.add(pane), {-0.4f, -0.4f, 0.3f}, {0.4f, -0.4f, 0.3f}, {0.4f, 0.4f, 0.3f}, {-0.4f, 0.4f, 0.3f});
    Material paint = testing::metal({0.8f, 0.2f, 0.1f}, 0.3f);
    paint.metalness = 0.5f;
    maker.ball(maker.add(paint), {0, 0, -0.2f}, 0.25f, 8);
    check_integrators_agree(maker.make(gradient_environment()), 3000);
}

TEST_CASE("agreement: the path tracer agrees with brute force through clear, tinted and frosted glass and under coats")
{
    for (const float alpha : {0.0f, 0.25f}) {
        SceneMaker maker;
        add_room(maker);
        maker.ball(maker.add(testing::glass(1.5f, alpha, {0.2f, 0.6f, 0.9f})), {0.15f, 0, -0.25f}, 0.22f, 8);
        maker.box(maker.add(testing::glass(1.3f, 0.4f)), {-0.45f, -0.2f, -0.45f}, {-0.15f, 0.1f, -0.1f});
        Material paint = testing::diffuse({0.6f, 0.2f, 0.1f});
        paint.coat = 0.8f;
        paint.coat_alpha = 0.1f;
        paint.finish();
        maker.ball(maker.add(paint), {0, 0.3f, -0.35f}, 0.15f, 8);
        check_integrators_agree(maker.make(gradient_environment()), 3000);
    }
}

TEST_CASE("agreement: the path tracer agrees with brute force in smoke around a ball, a lamp and a pane")
{
    SceneMaker maker;
    add_room(maker);
    Material pane = testing::diffuse({0.3f, 0.5f, 0.3f});
    pane.opacity = 0.4f;
    maker.quad(maker.add(pane), {-0.4f, -0.3f, -0.4f}, {0.4f, -0.3f, -0.4f}, {0.4f, -0.3f, 0.4f}, {-0.4f, -0.3f, 0.4f});
    maker.ball(maker.add(testing::metal({0.9f, 0.7f, 0.3f}, 0.2f)), {0, 0, -0.2f}, 0.25f, 8);
    maker.add(SphereLight{{0.1f, -0.1f, 0.3f}, 0.1f, {8, 6, 4}});
    maker.fill(testing::smoke());
    check_integrators_agree(maker.make(gradient_environment()), 3000);
}

TEST_CASE("agreement: the path tracer agrees with brute force on brushed metal and paint and on cloth")
{
    SceneMaker maker;
    add_room(maker);
    Material metal = testing::metal({0.9f, 0.7f, 0.3f}, 0.2f), paint = testing::glossy({0.2f, 0.4f, 0.6f}, 0.3f);
    for (Material* m : {&metal, &paint}) {
        m->anisotropy = 0.9f;
        m->anisotropy_turns = 0.1f;
        m->finish();
    }
    maker.ball(maker.add(metal), {0.15f, 0, -0.25f}, 0.22f, 8);
    maker.ball(maker.add(paint), {-0.25f, -0.1f, -0.3f}, 0.18f, 8);
    Material cloth = testing::diffuse({0.4f, 0.1f, 0.1f});
    cloth.sheen = 0.8f;
    cloth.sheen_colour = {0.9f, 0.8f, 1};
    cloth.finish();
    maker.ball(maker.add(cloth), {0, 0.3f, -0.35f}, 0.15f, 8);
    cloth.coat = 1;
    cloth.finish();
    maker.quad(maker.add(cloth), {-0.5f, -0.4f, -0.5f}, {-0.5f, -0.4f, 0}, {0, -0.45f, 0}, {0, -0.45f, -0.5f});
    check_integrators_agree(maker.make(gradient_environment()), 4000);
}

TEST_CASE(
    "agreement: the path tracer agrees with brute force under spherical and rectangular extra lights and a sky picture")
{
    SceneMaker maker;
    add_room(maker);
    maker.ball(maker.add(testing::metal({0.9f, 0.7f, 0.3f}, 0.1f)), {0, 0, -0.2f}, 0.25f, 8);
    maker.add(SphereLight{{0.4f, 0.2f, 0.2f}, 0.1f, {8, 6, 4}});
    maker.add(RectangleLight{{-2, -0.5f, 0.5f}, {0, 1, 0}, {0, 0, 1}, grey(4)});
    auto picture = std::make_shared<RadiancePicture>();
    picture->width = 4;
    picture->height = 2;
    for (int k = 0; k < 8; ++k) picture->pixels.push_back(grey(k == 1 ? 4.0f : 0.3f));
    Environment environment = constant_environment(0);
    environment.picture = picture;
    check_integrators_agree(maker.make(environment), 3000);
}

TEST_CASE("agreement: the path tracer agrees with brute force among a thousand lamps of different power")
{
    SceneMaker maker;
    maker.ball(maker.add(testing::glossy({0.4f, 0.4f, 0.6f}, 0.3f)), {}, 0.35f, 8);
    for (uint32_t k = 0; k < 500; ++k) {
        Sampler sampler(12, k, 0);
        const Vec3 at = square_to_sphere(sampler.next_2d()) * 0.8f;
        const Vec2 u = sampler.next_2d();
        const Frame frame(normalized(at));
        const Vec3 s = frame.tangent * 0.03f, t = frame.bitangent * 0.03f;
        maker.quad(maker.add(testing::lamp(grey(10 * u.x * u.x))), at, at + s, at + s + t, at + t);
    }
    check_integrators_agree(maker.make(constant_environment(0.1f)), 4000);
}

}  // namespace lumi::baker
