// SPDX-License-Identifier: MIT
#include "lumi/proxy/proxy_surface.h"

#include <catch2/catch.hpp>
#include <random>

#include "proxy/proxy_comparison.h"

using namespace lumi;
using namespace lumi::test;
using reference::Vec3;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSidePx = 10;
constexpr int kRandomViews = 3;
constexpr uint32_t kBallSteps = 6;
constexpr size_t kViewStep = 3;
#else
constexpr int32_t kSidePx = 72;
constexpr int kRandomViews = 60;
constexpr uint32_t kBallSteps = 24;
constexpr size_t kViewStep = 1;
#endif

// The views at the ends of every range, some of them on an emulated board.
std::vector<View> views()
{
    const std::vector<View> all = extreme_views(kSidePx);
    std::vector<View> chosen;
    for (size_t k = 0; k < all.size(); k += kViewStep) chosen.push_back(all[k]);
    return chosen;
}

struct NamedMesh {
    const char* name;
    TestMesh mesh;
};

std::vector<NamedMesh> meshes()
{
    return {{"wavy ball", ball(kBallSteps, kBallSteps, 0.65, 0.1)},
            {"full sphere", ball(kBallSteps, 16, 0.985)},
            {"plate", plate(0.7)},
            {"needle", needle()}};
}

Vec3 random_direction(std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    while (true) {
        const Vec3 v = {uniform(random), uniform(random), uniform(random)};
        const double length = reference::length(v);
        if (length > 0.1 && length < 1) return (1 / length) * v;
    }
}

}  // namespace

TEST_CASE("surfaces at the ends of every range lie where rays meet the mesh", "[proxy]")
{
    for (const NamedMesh& m : meshes()) {
        const PackedMesh mesh(m.mesh);
        for (const View& view : views()) {
            INFO(m.name << ", " << view.name);
            check(compare_centres(mesh.view, view.pose, view.image));
            check(compare_samples(mesh.view, view.pose, view.image));
        }
    }
}

TEST_CASE("surfaces from random views lie where rays meet the mesh", "[proxy]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    const std::vector<NamedMesh> all = meshes();
    for (int k = 0; k < kRandomViews; ++k) {
        const NamedMesh& m = all[static_cast<size_t>(k) % all.size()];
        const double distance = 1.01 + std::pow(uniform(random), 3) * 8;
        const Vec3 eye = distance * random_direction(random), target = 0.8 * random_direction(random);
        const Pose pose = look_at(eye, target, 360 * uniform(random));
        const Image image = {kSidePx, kSidePx, degrees(5 + 110 * uniform(random))};
        INFO(m.name << ", view " << k << " from " << distance);
        const PackedMesh mesh(m.mesh);
        check(compare_centres(mesh.view, pose, image));
        check(compare_samples(mesh.view, pose, image));
    }
}

TEST_CASE("a plate is seen at grazing angles down to its edge", "[proxy]")
{
    const PackedMesh mesh(plate(0.7));
    for (const double height : {0.3, 0.05, 0.01, 0.002, 0.0}) {
        INFO("eye " << height << " above the plate");
        check(compare_centres(mesh.view, look_at({1.3, 0.4, height}, {0, 0, 0}), {kSidePx, kSidePx, degrees(70)}));
    }
}

TEST_CASE("triangles of any size, through the near plane and beside the image, are drawn where they are", "[proxy]")
{
    std::mt19937 random(11);
    for (int k = 0; k < kRandomViews; ++k) {
        const PackedMesh mesh(soup(random, 12));
        const double distance = k % 2 == 0 ? 1.01 : 1.5;
        const Pose pose = look_at(distance * random_direction(random), random_direction(random));
        const Image image = {kSidePx, kSidePx / 2, degrees(k % 3 == 0 ? 4 : 100)};
        INFO("soup " << k);
        check(compare_centres(mesh.view, pose, image));
        check(compare_samples(mesh.view, pose, image));
    }
}

TEST_CASE("empty and degenerate meshes show nothing", "[proxy]")
{
    TestMesh points;
    points.vertices = {vertex_at(0, 0, 0), vertex_at(0.5, 0, 0), vertex_at(0.25, 0, 0)};
    points.triangles = {{0, 0, 0}, {0, 1, 1}, {1, 0, 1}, {2, 2, 0}};
    points.flags = format::kTwoSided;
    TestMesh unused = points;
    unused.triangles.clear();
    for (const TestMesh& m : {TestMesh{}, unused, points}) {
        const PackedMesh mesh(m);
        for (const View& view : views()) {
            INFO(view.name);
            const SurfacePicture picture = draw_surface<4>(mesh.view, view.pose, view.image);
            size_t seen = 0;
            for (const auto& pixel : picture.pixels) seen += pixel.size();
            CHECK(seen == 0);
        }
    }
}

TEST_CASE("one-sided triangles are seen from outside alone, two-sided ones from both sides", "[proxy]")
{
    TestMesh one = plate(0.7);
    one.flags = 0;
    const PackedMesh one_sided(one), two_sided(plate(0.7));
    const Image image = {16, 16, degrees(40)};
    const Pose above = look_at({0.3, 0, 2}, {0, 0, 0}), below = look_at({0.3, 0, -2}, {0, 0, 0});
    CHECK(draw_surface<1>(one_sided.view, above, image).at(8, 8).size() == 1);
    CHECK(draw_surface<1>(one_sided.view, below, image).at(8, 8).empty());
    CHECK(draw_surface<1>(two_sided.view, above, image).at(8, 8).size() == 1);
    CHECK(draw_surface<1>(two_sided.view, below, image).at(8, 8).size() == 1);
}
