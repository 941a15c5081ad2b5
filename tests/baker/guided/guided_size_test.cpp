// SPDX-License-Identifier: MIT
// Sizes of guided fields before they are baked, and proxies that bakes share.
#include <catch2/catch.hpp>
#include <cmath>

#include "lumi/baker/bake.h"
#include "lumi/baker/guided.h"
#include "support/bake_scenes.h"

namespace lumi::baker
{
namespace
{

Scene small_scene()
{
    return testing::ball_over_floor(8, studio_environment());
}

GuidedSettings small_settings()
{
    GuidedSettings s;
    s.origins = 96;
    s.chart_size = 40;
    s.proxy_triangles = 200;
    s.mean_resolution = 16;
    s.samples = 1;
    s.threads = 2;
    return s;
}

// Every kind of guided field.
std::vector<GuidedSettings> kinds()
{
    std::vector<GuidedSettings> all(8, small_settings());
    all[1].mean_format = format::MeanFormat::rgb565;
    all[2].mean_resolution = 0;
    all[3].texel = format::GuidedTexel::none;
    all[4].texel = format::GuidedTexel::index8;
    all[5].occlusion = false;
    all[5].used_origins = 61;
    all[6].surface = format::GuidedSurface::focus;
    all[7].texel = format::GuidedTexel::vq8;
    return all;
}

}  // namespace

TEST_CASE("the size of a guided field is known to the byte before it is baked")
{
    const Scene scene = small_scene();
    ProxyCache cache;
    for (const GuidedSettings& settings : kinds())
        CHECK(guided_file_bytes(scene, settings, cache) == guided_field(scene, settings).file.size());
}

TEST_CASE("a size estimated from sixteen charts is right to two hundredths")
{
    const Scene scene = small_scene();
    ProxyCache cache;
    for (GuidedSettings settings : kinds()) {
        settings.origins = 256;
        settings.used_origins = 0;
        const auto exact = static_cast<double>(guided_file_bytes(scene, settings, cache));
        const auto estimate = static_cast<double>(guided_file_bytes(scene, settings, cache, 16));
        CHECK(std::abs(estimate - exact) < 0.02 * exact);
    }
}

TEST_CASE("bakes that share proxies give the bytes of bakes that do not")
{
    const Scene scene = small_scene();
    ProxyCache cache;
    for (const uint32_t triangles : {200u, 100u, 200u}) {
        GuidedSettings settings = small_settings();
        settings.proxy_triangles = triangles;
        CHECK(guided_field(scene, settings, {}, &cache).file == guided_field(scene, settings).file);
    }
}

TEST_CASE("the size of what cannot be baked is refused like its bake")
{
    const Scene scene = small_scene();
    ProxyCache cache;
    GuidedSettings settings = small_settings();
    settings.chart_size = 5;
    CHECK_THROWS_AS(guided_file_bytes(scene, settings, cache), BakeError);
    CHECK_THROWS_AS(guided_field(scene, settings), BakeError);
}

}  // namespace lumi::baker
