// SPDX-License-Identifier: MIT
#include "trace/camera_rays.h"

#include <catch2/catch.hpp>

#include "lumi/baker/bake.h"
#include "lumi/baker/reference.h"
#include "lumi/chord/detail/sphere.h"
#include "support/shapes.h"

namespace lumi::baker
{
namespace
{

constexpr uint32_t kTurn360 = 0xFFFFFFFF;

Camera camera_at(double azimuth, double elevation, double distance, double fov_degrees, int32_t width, int32_t height)
{
    const auto turns = [](double degrees) { return static_cast<uint32_t>(degrees / 360 * kTurn360); };
    Camera camera{};
    const CameraError error =
        make_camera(detail::orbit(turns(azimuth), static_cast<int32_t>(elevation / 360 * kTurn360),
                                  static_cast<int32_t>(distance * kOneQ20)),
                    {width, height, turns(fov_degrees)}, camera);
    REQUIRE(error == CameraError::none);
    return camera;
}

double gap(const Vec3& a, const Vec3q30& b)
{
    const Vec3 d = a - Vec3{static_cast<float>(b.x), static_cast<float>(b.y), static_cast<float>(b.z)} * 0x1p-30f;
    return static_cast<double>(length(d));
}

}  // namespace

TEST_CASE("camera rays: enter and leave the sphere where the renderer says")
{
    double worst = 0;
    int compared = 0;
    for (const double distance : {1.01, 1.5, 3.0, 30.0, 1000.0}) {
        const double fov = distance > 10 ? 2.2 * 57.3 / distance < 2 ? 2 : 2.2 * 57.3 / distance : 60;
        const Camera camera = camera_at(33, 21, distance, fov, 64, 48);
        const CameraRays rays(camera);
        for (int32_t y = 0; y < 48; ++y) {
            for (int32_t x = 0; x < 64; ++x) {
                detail::SphereRay sphere_ray{};
                if (!detail::ray_at(camera, x, y, sphere_ray)) continue;
                const detail::SphereHits expected = detail::hits(camera, sphere_ray);
                const std::optional<Ray> ray = rays.ray(x + 0.5, y + 0.5);
                REQUIRE(ray);
                const float chord = -2 * dot(ray->origin, ray->direction);
                worst = std::max(worst, gap(ray->origin, expected.front));
                worst = std::max(worst, gap(ray->origin + ray->direction * chord, expected.back));
                ++compared;
            }
        }
    }
    INFO("worst gap " << worst << " of " << compared << " rays");
    CHECK(compared > 2000);
    CHECK(worst < 2e-5);  // binary32's 1e-7, up to 64 times as much near the rim, where a chord turns fastest
}

TEST_CASE("reference: a ball covers the pixels that its outline covers, brighter side up, over nothing")
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 1, 64);
    const Scene scene = maker.make({{1, 1, 1}, {0.2f, 0.2f, 0.2f}, {0, 0, 0}});
    const RgbaImage image = render_reference(scene, camera_at(0, 0, 3, 60, 48, 48), {16, 1, 2});
    REQUIRE(image.width == 48);
    REQUIRE(image.rgba.size() == 48 * 48 * 4);
    const auto pixel = [&](size_t x, size_t y) { return &image.rgba[4 * (y * 48 + x)]; };
    CHECK(pixel(24, 24)[3] == 255);
    CHECK(pixel(0, 0)[3] == 0);
    CHECK(pixel(0, 0)[0] == 0);
    CHECK(pixel(24, 12)[1] > pixel(24, 36)[1] + 40);
    // The disc's share of the image: outline at tan(asin(1/3)), image edge at tan(30°).
    double covered = 0;
    for (size_t k = 0; k < image.rgba.size(); k += 4) {
        covered += image.rgba[k + 3] / 255.0;
        REQUIRE(image.rgba[k] <= image.rgba[k + 3]);
    }
    const double outline = std::tan(std::asin(1 / 3.0)) / std::tan(3.14159265 / 6) * 24;
    CHECK(covered == Approx(3.14159265 * outline * outline).epsilon(0.01));
}

TEST_CASE("reference: the same pixels for any number of threads, others for another seed")
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::glossy({0.6f, 0.2f, 0.1f}, 0.3f)), {}, 1, 8);
    const Scene scene = maker.make(gradient_environment());
    const Camera camera = camera_at(10, 20, 3, 45, 24, 16);
    const RgbaImage one = render_reference(scene, camera, {2, 1, 1});
    CHECK(render_reference(scene, camera, {2, 1, 2}).rgba == one.rgba);
    CHECK(render_reference(scene, camera, {2, 1, 3}).rgba == one.rgba);
    CHECK(render_reference(scene, camera, {2, 2, 3}).rgba != one.rgba);
}

TEST_CASE("reference: no samples is an error, a callback that returns false cancels")
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 1, 8);
    const Scene scene = maker.make(gradient_environment());
    const Camera camera = camera_at(10, 20, 3, 45, 8, 8);
    CHECK_THROWS_AS(render_reference(scene, camera, {0, 1, 1}), BakeError);
    CHECK_THROWS_AS(render_reference(scene, camera, {1, 1, 1}, [](const Progress&) { return false; }), Cancelled);
}

}  // namespace lumi::baker
