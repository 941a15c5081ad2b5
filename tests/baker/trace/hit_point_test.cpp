// SPDX-License-Identifier: MIT
#include "trace/hit_point.h"

#include <catch2/catch.hpp>

#include "support/picture_bytes.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"
#include "support/statistics.h"
#include "trace/error_gauge.h"

namespace lumi::baker
{
namespace
{

Ray ray_to(const Vec3& from, const Vec3& to)
{
    return {from, normalized(to - from)};
}

HitPoint seen(const Scene& scene, const Ray& ray)
{
    const std::optional<Hit> hit = scene.data().accelerator.closest(ray);
    REQUIRE(hit);
    return hit_point_at(scene.data(), ray, *hit);
}

Scene loaded_scene(const testing::ScratchFolder& folder, const std::string& obj)
{
    std::vector<std::string> warnings;
    LoadOptions options;
    options.up = UpAxis::z;
    options.environment = constant_environment(1);
    Scene scene = load_scene(folder.write("s.obj", obj), options, warnings);
    REQUIRE(warnings.empty());
    return scene;
}

}  // namespace

TEST_CASE("surface: a picture lies on the triangles as its coordinates say, and the radiance shows it")
{
    const testing::ScratchFolder folder;
    folder.write("m.mtl", "newmtl x\nmap_Kd t.png\n");
    // Red and green above, blue and white below.
    folder.write("t.png", testing::rgb_png(2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}));
    const Scene scene = loaded_scene(folder,
                                     "mtllib m.mtl\nusemtl x\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                                     "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    const float place = 0.5f / scene.radius();  // centres of the four pixels
    const auto colour = [&](float x, float y) {
        const Ray ray = ray_to({0.1f, 0.2f, 1}, {x, y, 0});
        const Rgb8 base = srgb_encode(seen(scene, ray).values.base);
        Sampler sampler(1, 0, 0);
        Estimate estimate;
        for (uint32_t s = 0; s < 256; ++s) {
            sampler.start(s);
            estimate.add(PathTracer(scene.data()).trace(ray, sampler));
        }
        CHECK(std::abs(estimate.colour().r - base.r) <= 6);
        CHECK(std::abs(estimate.colour().g - base.g) <= 6);
        return std::array<int, 3>{base.r, base.g, base.b};
    };
    CHECK(colour(-place, place) == std::array<int, 3>{255, 0, 0});
    CHECK(colour(place, place) == std::array<int, 3>{0, 255, 0});
    CHECK(colour(-place, -place) == std::array<int, 3>{0, 0, 255});
    CHECK(colour(place, -place) == std::array<int, 3>{255, 255, 255});
}

TEST_CASE("surface: normals are interpolated and turned to the viewer, on both sides")
{
    const testing::ScratchFolder folder;
    const Scene scene = loaded_scene(folder,
                                     "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn -1 0 1\nvn 1 0 1\nvn 0 0 1\n"
                                     "f 1//1 2//2 3//3\n");
    const float y = scene.data().mesh.position(0, 0).y;
    const float x = scene.data().mesh.position(0, 1).x;
    const HitPoint middle = seen(scene, ray_to({0, y * 0.999f, 1}, {0, y * 0.999f, 0}));
    CHECK(static_cast<double>(middle.frame.normal.z) == Approx(1).epsilon(1e-3));
    const HitPoint right = seen(scene, ray_to({x * 0.5f, y * 0.999f, 1}, {x * 0.5f, y * 0.999f, 0}));
    CHECK(static_cast<double>(right.frame.normal.x) > 0.3);
    const HitPoint below = seen(scene, ray_to({x * 0.5f, y * 0.999f, -1}, {x * 0.5f, y * 0.999f, 0}));
    CHECK(static_cast<double>(below.frame.normal.x) < -0.3);
    CHECK(static_cast<double>(below.geometric_normal.z) == -1);
}

TEST_CASE("surface: rays that leave a convex body never meet it again")
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 1, 20);
    const Scene scene = maker.make(constant_environment(1));
    uint32_t met = 0;
    for (uint32_t k = 0; k < 20000; ++k) {
        Sampler sampler(1, k, 0);
        const Vec3 from = square_to_sphere(sampler.next_2d()) * 2;
        const HitPoint point = seen(scene, ray_to(from, square_to_sphere(sampler.next_2d()) * 0.5f));
        const Vec3 local = square_to_cosine_hemisphere(sampler.next_2d());
        met += scene.data().accelerator.blocked(point.ray_towards(point.frame.to_world(local))) ? 1u : 0u;
    }
    CHECK(met == 0);
}

TEST_CASE("surface: light passes thin panes by what they leave, and nothing opaque")
{
    testing::SceneMaker maker;
    Material pane = testing::diffuse(grey(0.5f));
    pane.opacity = 0.25f;
    const uint32_t glass = maker.add(pane);
    for (const float z : {0.0f, 0.2f, 0.4f})
        maker.quad(glass, {-0.3f, -0.3f, z}, {0.3f, -0.3f, z}, {0.3f, 0.3f, z}, {-0.3f, 0.3f, z});
    const uint32_t wall = maker.add(testing::diffuse(grey(0.5f)));
    maker.quad(wall, {-0.3f, -0.3f, -0.5f}, {0.3f, -0.3f, -0.5f}, {0.3f, 0.3f, -0.5f}, {-0.3f, 0.3f, -0.5f});
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(1));
    const Vec3 down = {0, 0, -1};
    CHECK(static_cast<double>(transmittance(scene.data(), {{0.1f, 0, 0.9f}, down, 1.2f}).g) ==
          Approx(0.75 * 0.75 * 0.75));
    CHECK(static_cast<double>(transmittance(scene.data(), {{0.1f, 0, 0.9f}, down, 0.6f}).g) == Approx(0.75));
    CHECK(transmittance(scene.data(), {{0.1f, 0, 0.9f}, down, 1.8f}).g == 0);
    CHECK(transmittance(scene.data(), {{0.1f, 0, 0.9f}, {1, 0, 0}, 5}).g == 1);
}

}  // namespace lumi::baker
