// SPDX-License-Identifier: MIT
#include "trace/error_gauge.h"

#include <catch2/catch.hpp>

#include "chord/texel_tracer.h"
#include "lumi/baker/merge.h"
#include "math/sampler.h"
#include "support/bake_scenes.h"
#include "support/statistics.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

float uniform(uint32_t k)
{
    Sampler sampler(7, k, 0);
    return sampler.next_1d();
}

ErrorGauge gauge_of(uint32_t paths, float (*radiance)(uint32_t))
{
    ErrorGauge gauge;
    for (uint32_t k = 0; k < paths; ++k) gauge.add({true, grey(radiance(k))});
    return gauge;
}

// A glossy ball that mirrors a small, bright lamp: light that few paths find.
Scene sparkling_scene()
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::glossy({0.5f, 0.4f, 0.3f}, 0.15f)), {0, 0, 0.1f}, 0.4f, 12);
    maker.box(maker.add(testing::diffuse({0.6f, 0.5f, 0.4f})), {-0.55f, -0.55f, -0.45f}, {0.55f, 0.55f, -0.3f});
    maker.ball(maker.add(testing::lamp(grey(60))), {0.4f, 0.3f, 0.6f}, 0.04f, 6);
    return maker.make(constant_environment(0.3f));
}

BakeSettings adaptive_settings(uint32_t samples, float levels)
{
    BakeSettings s = testing::tiny_settings();
    s.origins = 40;
    s.directions = 60;
    s.samples = samples;
    s.max_error_levels = levels;
    return s;
}

// The green level that a texel stores.
double stored(const TexelTracer& tracer, uint32_t i, uint32_t j)
{
    return tracer.estimate(tracer.disc(i), i, j).colour().g;
}

struct Comparison {
    testing::Mean fixed, adaptive;  // squared errors in levels, against many paths
    testing::Mean shift;            // from fixed to adaptive
};

Comparison compare(const Scene& scene, uint32_t samples, float levels)
{
    BakeSettings truth_settings = adaptive_settings(2048, 0);
    truth_settings.seed = 2;
    const TexelTracer truth(scene.data(), truth_settings), fixed(scene.data(), adaptive_settings(samples, 0)),
        adaptive(scene.data(), adaptive_settings(samples, levels));
    Comparison result;
    for (uint32_t i = 0; i < 20; ++i) {
        for (uint32_t j = 0; j < 60; ++j) {
            if (!truth.estimate(truth.disc(i), i, j).mostly_covered()) continue;
            const double t = stored(truth, i, j), f = stored(fixed, i, j), a = stored(adaptive, i, j);
            result.fixed.add((f - t) * (f - t));
            result.adaptive.add((a - t) * (a - t));
            result.shift.add(a - f);
        }
    }
    return result;
}

// The share of its paths that a bake leaves out.
double saved_share(const Scene& scene, const BakeSettings& settings)
{
    const ScratchFolder folder;
    Progress last;
    bake_field(scene, settings, folder.at("f.lumi"), [&](const Progress& p) {
        last = p;
        return true;
    });
    CHECK(last.rays_done == last.rays_total);
    return static_cast<double>(last.rays_saved) / static_cast<double>(last.rays_total);
}

}  // namespace

TEST_CASE("error gauge: tells the standard error of the mean, carried through the sRGB curve")
{
    const ErrorGauge gauge = gauge_of(4096, uniform);
    const double error = std::sqrt(1.0 / 12 / 4096);
    // d/dL of 1.055·L^(1/2.4) at the mean of 1/2
    const double slope = 1.055 / 2.4 * std::pow(0.5, 1 / 2.4 - 1);
    CHECK(static_cast<double>(gauge.error_levels(ToneCurve::srgb)) == Approx(255 * slope * error).epsilon(0.02));
    CHECK(gauge.error_levels(ToneCurve::reinhard) < gauge.error_levels(ToneCurve::srgb));
}

TEST_CASE("error gauge: the error falls as one over the root of the number of paths")
{
    const float few = gauge_of(1024, uniform).error_levels(ToneCurve::srgb);
    const float many = gauge_of(16384, uniform).error_levels(ToneCurve::srgb);
    CHECK(static_cast<double>(few / many) == Approx(4).epsilon(0.05));
}

TEST_CASE("error gauge: settles where a batch ends, never before the first look")
{
    ErrorGauge gauge;
    for (uint32_t n = 1; n <= 40; ++n) {
        gauge.add({});
        CHECK(gauge.settled(ToneCurve::srgb, 1) == (n >= 16 && n % 8 == 0));
    }
}

TEST_CASE("error gauge: noise that the stored scale clips does not count")
{
    const ErrorGauge bright = gauge_of(16, [](uint32_t k) { return 10 + 5 * uniform(k); });
    CHECK(bright.settled(ToneCurve::srgb, 1));
    CHECK_FALSE(gauge_of(16, uniform).settled(ToneCurve::srgb, 1));
}

TEST_CASE("error gauge: a texel whose paths disagree on coverage is not settled")
{
    ErrorGauge gauge;
    for (uint32_t k = 0; k < 64; ++k) {
        gauge.add({k != 10, {}});
        CHECK(gauge.settled(ToneCurve::srgb, 1) == false);
    }
}

TEST_CASE("error gauge: sixteen equal paths are not proof that there are no brighter ones")
{
    const auto equal = [](uint32_t) { return 0.5f; };
    CHECK_FALSE(gauge_of(16, equal).settled(ToneCurve::srgb, 1));
    CHECK(gauge_of(128, equal).settled(ToneCurve::srgb, 1));
}

TEST_CASE("adaptive sampling: rare bright paths are not lost: errors stay as they are with all paths, without a shift")
{
    const Scene scene = sparkling_scene();
    const Comparison result = compare(scene, 256, 1);
    const double fixed = std::sqrt(result.fixed.value()), adaptive = std::sqrt(result.adaptive.value());
    INFO("rms error with all paths " << fixed << ", adaptive " << adaptive << ", shift " << result.shift.value()
                                     << " +- " << result.shift.error());
    CHECK(adaptive < 1.02 * fixed);
    CHECK(std::abs(result.shift.value()) < 0.05);
    CHECK(saved_share(scene, adaptive_settings(256, 1)) > 0.3);
}

TEST_CASE("adaptive sampling: zero levels take every path, and so do bakes of sixteen paths")
{
    CHECK(saved_share(sparkling_scene(), adaptive_settings(40, 0)) == 0);
    CHECK(saved_share(sparkling_scene(), adaptive_settings(ErrorGauge::kFirstLook, 5)) == 0);
}

TEST_CASE("adaptive sampling: threads and shards do not change a byte, saved rays count as done")
{
    const Scene scene = sparkling_scene();
    for (const TexelFormat texel : {TexelFormat::rgb888, TexelFormat::palette8}) {
        BakeSettings settings = adaptive_settings(48, 2);
        settings.texel = texel;
        settings.origins = 12;
        const std::string whole = testing::baked(scene, settings);
        settings.threads = 3;
        CHECK(testing::baked(scene, settings) == whole);
        CHECK(saved_share(scene, settings) > 0.1);
        const ScratchFolder folder;
        for (const uint32_t k : {1u, 2u}) bake_shard(scene, settings, {k, 2}, folder.at("s" + std::to_string(k)));
        merge_shards({folder.at("s2"), folder.at("s1")}, folder.at("m.lumi"));
        CHECK(testing::read_bytes(folder.at("m.lumi")) == whole);
    }
}

TEST_CASE("adaptive sampling: levels that cannot be are refused")
{
    for (const float levels : {-1.0f, 256.0f, std::nanf("")})
        CHECK_THROWS_WITH(field_file_bytes(adaptive_settings(2, levels)), Catch::Contains("0 to 255 levels"));
}

}  // namespace lumi::baker
