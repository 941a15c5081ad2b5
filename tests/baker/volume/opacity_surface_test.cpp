// SPDX-License-Identifier: MIT
// Where a volume looks solid, and what surface fields make of it.
#include "volume/iso_surface.h"

#include <catch2/catch.hpp>

#include "scene/scene_data.h"
#include "support/volumes.h"
#include "surface/surface_scenes.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{
namespace
{

constexpr float kRadius = 0.4f;

Volume ball(float density)
{
    return {testing::grid_of(
                33, 33, 33, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f},
                [](float x, float y, float z) { return std::sqrt(x * x + y * y + z * z); }),
            TransferFunction({{kRadius - 0.01f, grey(0.8f), density}, {kRadius + 0.01f, grey(0.8f), 0}})};
}

Scene scene_of(float density, bool solid)
{
    const auto parts = std::make_unique<SceneParts>();  // on the stack, g++ 12 warns of members that are not set
    parts->volume = ball(density);
    LoadOptions options;
    options.up = UpAxis::z;
    options.solid_volume = solid;
    return build_scene(std::move(*parts), options);
}

}  // namespace

TEST_CASE("opacity surface: in even fog the depth is that of the nearest face")
{
    const Volume fog = {testing::grid_of(9, 6, 5, {0, 0, 0}, {4, 5, 2}, [](float, float, float) { return 1.0f; }),
                        TransferFunction({{1, grey(1), 3}})};
    const Grid depths = optical_depths(fog);
    for (uint32_t k = 0; k < 5; ++k) {
        for (uint32_t j = 0; j < 6; ++j) {
            for (uint32_t i = 0; i < 9; ++i) {
                const float nearest =
                    std::min({0.5f * static_cast<float>(std::min(i, 8 - i)), static_cast<float>(std::min(j, 5 - j)),
                              0.5f * static_cast<float>(std::min(k, 4 - k))});
                INFO(i << " " << j << " " << k);
                CHECK(static_cast<double>(depths.values[(k * 6 + j) * 9 + i]) == Approx(3 * nearest).margin(1e-5));
            }
        }
    }
}

TEST_CASE("opacity surface: of a ball of fog it lies as deep as half of the light gets")
{
    constexpr float kDensity = 20;
    const Mesh mesh = opacity_surface(ball(kDensity));
    REQUIRE(mesh.triangle_count() > 500);
    // Ways out between the 26 are up to a tenth longer than straight ones.
    const float depth = 0.693f / kDensity, slack = 0.012f;
    for (const Vec3& p : mesh.positions) {
        CHECK(length(p) > kRadius - depth - slack);
        CHECK(length(p) < kRadius - 0.9f * depth + slack);
    }
    CHECK(opacity_surface(ball(1)).corners.empty());
}

TEST_CASE("opacity surface: light passes the shell, and neither paths nor fingerprint know of it")
{
    const Scene with = scene_of(20, true), without = scene_of(20, false);
    REQUIRE(with.triangle_count() > 0);
    CHECK(without.triangle_count() == 0);
    CHECK(with.fingerprint() == without.fingerprint());
    for (uint32_t k = 0; k < 200; ++k) {
        Sampler aim(4, k, 0), a(5, k, 0), b(5, k, 0);
        const Vec3 from = square_to_sphere(aim.next_2d());
        const Ray ray = {from, normalized(square_to_sphere(aim.next_2d()) * 0.5f - from)};
        const PathResult one = PathTracer(with.data()).trace(ray, a), other = PathTracer(without.data()).trace(ray, b);
        CHECK(one.covered == other.covered);
        CHECK(one.radiance.g == other.radiance.g);
    }
}

TEST_CASE("opacity surface: of a dense ball few paths miss the mesh, where nothing is solid surface fields are refused")
{
    SurfaceSettings settings;
    settings.triangles = 200;
    settings.threads = 1;
    CHECK(testing::planned(scene_of(300, true), settings).loss.missed < 0.05);
    CHECK_THAT(testing::planned(scene_of(1, true), settings).against, Catch::Contains("half transparent"));
}

}  // namespace lumi::baker
