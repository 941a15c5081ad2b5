// SPDX-License-Identifier: MIT
#include "path_tracer.h"

#include <catch2/catch.hpp>

#include "shapes.h"
#include "statistics.h"
#include "surface.h"

namespace lumi::baker
{
namespace
{

using testing::kSigmas;
using testing::Mean;
using testing::SceneMaker;

// The plainest path tracer there is: it never aims at lights and never plays roulette.
class BruteForce : public Integrator
{
public:
    explicit BruteForce(const SceneData& scene) : scene_(scene) {}

    PathResult trace(const Ray& first, Sampler& sampler) const override
    {
        PathResult result;
        Rgb throughput = grey(1);
        Ray ray = first;
        for (int bounce = 0; bounce < kMaxBounces; ++bounce) {
            const std::optional<Hit> hit = closest_opaque(scene_, ray, sampler);
            if (!hit) {
                if (result.covered) {
                    result.radiance = result.radiance + throughput * scene_.lights.sky_radiance(ray.direction);
                }
                break;
            }
            result.covered = true;
            const Surface surface = surface_at(scene_, ray, *hit);
            result.radiance = result.radiance + throughput * surface.emission;
            const Vec3 wo = surface.frame.to_local(-ray.direction);
            const Bsdf bsdf = surface.material->bsdf(surface.values, sampler.next_1d());
            const float u = sampler.next_1d();
            const std::optional<BsdfSample> s = bsdf.sample(wo, u, sampler.next_2d());
            if (!s) {
                break;
            }
            throughput = throughput * s->weight;
            ray = surface.ray_towards(normalized(surface.frame.to_world(s->wi)));
        }
        return result;
    }

private:
    const SceneData& scene_;
};

// Independent paths along rays from all around towards points near the centre.
std::vector<Mean> radiance(const Integrator& integrator, uint32_t paths, uint32_t rays, uint64_t seed)
{
    std::vector<Mean> means(rays);
    for (uint32_t r = 0; r < rays; ++r) {
        Sampler aim(99, r, 0);
        const Vec3 start = square_to_sphere(aim.next_2d()) * 1.5f;
        const Vec3 target = square_to_sphere(aim.next_2d()) * 0.3f;
        for (uint32_t k = 0; k < paths; ++k) {
            Sampler sampler(seed, r, k);
            const PathResult path = integrator.trace({start, normalized(target - start)}, sampler);
            means[r].add(static_cast<double>(luminance(path.radiance)));
        }
    }
    return means;
}

Mean along(const Scene& scene, const Ray& ray, uint32_t paths)
{
    const PathTracer tracer(scene.data());
    Mean mean;
    for (uint32_t k = 0; k < paths; ++k) {
        Sampler sampler(21, k, 0);
        mean.add(static_cast<double>(tracer.trace(ray, sampler).radiance.g));
    }
    return mean;
}

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

void add_room(SceneMaker& maker)
{
    const uint32_t white = maker.add(testing::diffuse(grey(0.7f)));
    const uint32_t red = maker.add(testing::diffuse({0.6f, 0.1f, 0.1f}));
    maker.quad(white, {-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {-0.5f, 0.5f, -0.5f});
    maker.quad(red, {-0.5f, 0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}, {-0.5f, 0.5f, 0.5f});
    const uint32_t light = maker.add(testing::lamp({6, 5, 4}));
    maker.quad(light, {-0.3f, -0.3f, 0.55f}, {0.3f, -0.3f, 0.55f}, {0.3f, 0.3f, 0.55f}, {-0.3f, 0.3f, 0.55f});
}

}  // namespace

TEST_CASE("path tracer: a convex diffuse body in constant light has radiance albedo × light everywhere")
{
    SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.6f))), {}, 1);
    const Scene scene = maker.make(constant_environment(0.8f));
    for (uint32_t r = 0; r < 20; ++r) {
        Sampler aim(1, r, 0);
        const Vec3 start = square_to_sphere(aim.next_2d()) * 2;
        const Mean mean = along(scene, {start, normalized(square_to_sphere(aim.next_2d()) * 0.5f - start)}, 2000);
        CHECK(mean.value() == Approx(0.48).margin(kSigmas * mean.error() + 1e-4));
    }
}

TEST_CASE("path tracer: white surfaces in white light stay at most white, whatever they are made of")
{
    for (const float alpha : {0.01f, 0.1f, 0.4f, 1.0f}) {
        for (const bool metallic : {false, true}) {
            SceneMaker maker;
            const Material material = metallic ? testing::metal(grey(1), alpha) : testing::glossy(grey(1), alpha);
            maker.ball(maker.add(material), {0, 0, 0.2f}, 0.5f);
            const uint32_t white = maker.add(testing::diffuse(grey(1)));
            maker.quad(white, {-0.6f, -0.6f, -0.4f}, {0.6f, -0.6f, -0.4f}, {0.6f, 0.6f, -0.4f}, {-0.6f, 0.6f, -0.4f});
            const Scene scene = maker.make(constant_environment(1));
            for (const Mean& mean : radiance(PathTracer(scene.data()), 500, 10, 5)) {
                INFO("alpha " << alpha << (metallic ? " metal " : " plastic ") << mean.value() << " ± "
                              << mean.error());
                CHECK(mean.value() <= 1 + kSigmas * mean.error() + 1e-5);
            }
        }
    }
}

TEST_CASE("path tracer: a patch under a rectangular lamp has the closed form's radiance")
{
    constexpr float kHeight = 0.5f, kLight = 3, kAlbedo = 0.5f;
    for (const float half : {0.05f, 0.2f, 0.6f}) {
        SceneMaker maker;
        const uint32_t floor = maker.add(testing::diffuse(grey(kAlbedo)));
        maker.quad(floor, {-0.2f, -0.2f, 0}, {0.2f, -0.2f, 0}, {0.2f, 0.2f, 0}, {-0.2f, 0.2f, 0});
        const uint32_t light = maker.add(testing::lamp(grey(kLight)));
        maker.quad(light, {-half, -half, kHeight}, {half, -half, kHeight}, {half, half, kHeight},
                   {-half, half, kHeight});
        maker.span_unit_sphere();
        const Scene scene = maker.make(constant_environment(0));
        REQUIRE(static_cast<double>(scene.radius()) == Approx(1).epsilon(1e-5));

        // Form factor of a parallel rectangle over a point, four times the corner formula (Howell, "A Catalog of
        // Radiation Heat Transfer Configuration Factors", B-3).
        const double a = static_cast<double>(half / kHeight);
        const double root = std::sqrt(1 + a * a);
        const double form_factor = 4 / (2 * static_cast<double>(kPi)) * 2 * (a / root * std::atan(a / root));
        const double expected = static_cast<double>(kAlbedo * kLight) * form_factor;

        const Vec3 start = {0.75f, 0.003f, 0.1f};
        const Mean mean = along(scene, {start, normalized(Vec3{} - start)}, 20000);
        INFO("half side " << half << ": " << mean.value() << " for " << expected << " ± " << mean.error());
        CHECK(mean.value() == Approx(expected).margin(kSigmas * mean.error() + 2e-4 * expected));
        CHECK(mean.error() < 0.02 * expected);
    }
}

// Every bounce adds albedo times what the last one added: a geometric series that sees any error in long paths.
TEST_CASE("path tracer: inside a closed glowing room radiance is emission / (1 - albedo)")
{
    for (const float albedo : {0.0f, 0.5f, 0.8f}) {
        SceneMaker maker;
        Material wall = testing::diffuse(grey(albedo));
        wall.emission = grey(1);
        maker.box(maker.add(wall), {-0.5f, -0.4f, -0.3f}, {0.5f, 0.4f, 0.3f});
        const Scene scene = maker.make(constant_environment(0));
        const Mean mean = along(scene, {{0.1f, 0, 0}, normalized(Vec3{0.3f, 0.5f, -0.4f})}, 40000);
        const double expected = 1 / (1 - static_cast<double>(albedo));
        INFO("albedo " << albedo << ": " << mean.value() << " for " << expected << " ± " << mean.error());
        CHECK(mean.value() == Approx(expected).margin(kSigmas * mean.error() + 2e-4 * expected));
        CHECK(mean.error() < 0.01 * expected);
    }
}

TEST_CASE("path tracer: agrees with brute force on diffuse and glossy bodies under a lamp")
{
    SceneMaker maker;
    add_room(maker);
    maker.ball(maker.add(testing::glossy({0.2f, 0.4f, 0.6f}, 0.2f)), {0.2f, 0, -0.3f}, 0.2f, 8);
    maker.ball(maker.add(testing::metal({0.9f, 0.7f, 0.3f}, 0.3f)), {-0.2f, 0, -0.25f}, 0.22f, 8);
    check_integrators_agree(maker.make(constant_environment(0)), 4000);
}

TEST_CASE("path tracer: agrees with brute force under a gradient sky with a lamp")
{
    SceneMaker maker;
    add_room(maker);
    maker.ball(maker.add(testing::metal({0.9f, 0.7f, 0.3f}, 0.05f)), {0, 0, -0.2f}, 0.25f, 8);
    check_integrators_agree(maker.make(studio_environment()), 3000);
}

TEST_CASE("path tracer: agrees with brute force through a thin pane and with partly metallic paint")
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
    check_integrators_agree(maker.make(studio_environment()), 3000);
}

TEST_CASE("path tracer: the sky is not seen, a pane covers by its opacity")
{
    SceneMaker maker;
    Material pane = testing::diffuse(grey(0.5f));
    pane.opacity = 0.3f;
    maker.quad(maker.add(pane), {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
    const Scene scene = maker.make(constant_environment(1));
    const PathTracer tracer(scene.data());
    Mean covered;
    for (uint32_t k = 0; k < 10000; ++k) {
        Sampler sampler(1, k, 0);
        covered.add(tracer.trace({{0.1f, 0.1f, 1}, {0, 0, -1}}, sampler).covered ? 1 : 0);
        const PathResult beside = tracer.trace({{0.1f, 0.1f, 1}, {1, 0, 0}}, sampler);
        REQUIRE_FALSE(beside.covered);
        REQUIRE(is_black(beside.radiance));
    }
    CHECK(covered.value() == Approx(0.3).margin(kSigmas * covered.error()));
}

TEST_CASE("path tracer: the error falls as one over the root of the number of independent paths, or faster")
{
    SceneMaker maker;
    add_room(maker);
    const Scene scene = maker.make(studio_environment());
    const PathTracer tracer(scene.data());
    const Vec3 start = {0.1f, -1.2f, 0.2f};
    const Ray ray = {start, normalized(Vec3{0.1f, 0.2f, -0.5f} - start)};
    const auto spread = [&](uint32_t samples) {
        Mean means, squares;
        for (uint32_t texel = 0; texel < 400; ++texel) {
            Mean mean;
            Sampler sampler(8, texel, samples);
            for (uint32_t s = 0; s < samples; ++s) {
                sampler.start(s);
                mean.add(static_cast<double>(tracer.trace(ray, sampler).radiance.g));
            }
            means.add(mean.value());
        }
        return means.error();
    };
    const double coarse = spread(4), fine = spread(64);
    INFO("4 samples " << coarse << ", 64 samples " << fine);
    CHECK(fine < coarse / 4 * 1.15);
}

}  // namespace lumi::baker
