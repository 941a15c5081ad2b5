// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <map>

#include "mesh/mesh_fit.h"
#include "mesh/outside.h"
#include "mesh/sheets.h"
#include "mesh/simplify/simplify.h"

#include "support/shapes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

const ProgressCallback kSilent;

// The mean difference between the depths that both the scene and the mesh have, in radii.
double mean_depth_error(const Survey& survey, const Mesh& mesh)
{
    const MeshTracer tracer(mesh, Faces::front);
    uint32_t both = 0;
    double sum = 0;
    for (uint32_t i = 0; i < survey.origins(); ++i) {
        for (const SurveyRay& r : survey.look(i, tracer)) {
            if (r.mesh && std::isfinite(r.scene)) {
                ++both;
                sum += static_cast<double>(std::abs(r.scene - r.mesh->distance));
            }
        }
    }
    return sum / std::max(both, 1u);
}

// Hills seen from both sides, and a box that stands on them; each second square is wound the other way if asked for.
Scene terrain(bool wound_by_chance)
{
    constexpr int kSquares = 60;
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    const auto at = [](int x, int y) {
        const float noise = static_cast<float>((x * 7919 + y * 104729) % 31) / 31;
        const float side = 1.2f / kSquares;
        return Vec3{static_cast<float>(x) * side - 0.6f, static_cast<float>(y) * side - 0.6f, 0.02f * noise - 0.3f};
    };
    for (int y = 0; y < kSquares; ++y) {
        for (int x = 0; x < kSquares; ++x)
            if (wound_by_chance && (x * 31 + y * 17) % 3 == 0)
                maker.quad(matter, at(x, y), at(x, y + 1), at(x + 1, y + 1), at(x + 1, y));
            else
                maker.quad(matter, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
    }
    maker.box(matter, {-0.2f, -0.2f, -0.3f}, {0.2f, 0.2f, 0.3f});
    return maker.make(constant_environment(1));
}

// How many pairs of neighbouring triangles are wound against each other.
uint32_t torn_edges(const Mesh& mesh)
{
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> sides;
    for (const Mesh::Corners& c : mesh.corners)
        for (size_t i = 0; i < 3; ++i) ++sides[{c[i], c[(i + 1) % 3]}];
    return static_cast<uint32_t>(
        std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second > 1; }));
}

Scene box_with(bool ball_inside)
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    if (ball_inside) maker.ball(matter, {0, 0, 0}, 0.3f, 8);
    return maker.make(constant_environment(1));
}

}  // namespace

TEST_CASE("Simplified balls stay balls, and fitting brings them closer", "[mesh]")
{
    SceneMaker maker;
    maker.ball(maker.add(diffuse(grey(0.5f))), {0, 0, 0}, 0.8f, 48);
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(1));
    Job job(1, 2, kSilent);
    const Outside outside = outside_of(scene.data(), job);
    CHECK_FALSE(outside.two_sided);
    CHECK(outside.mesh.triangle_count() == scene.triangle_count());
    const Mesh rough = simplified(outside.mesh, 200);
    CHECK(rough.triangle_count() <= 200);
    CHECK(rough.triangle_count() > 150);
    const Survey survey(scene.data(), 64, 300, 5);
    const Mesh fine = fitted(rough, rough, Faces::front, survey, job);
    CHECK(mean_depth_error(survey, fine) < 0.6 * mean_depth_error(survey, rough));
}

TEST_CASE("What nobody can see is no part of the mesh", "[mesh]")
{
    const Scene alone = box_with(false), filled = box_with(true);
    Job job(1, 2, kSilent);
    CHECK(filled.triangle_count() > alone.triangle_count());
    CHECK(outside_of(filled.data(), job).mesh.triangle_count() == outside_of(alone.data(), job).mesh.triangle_count());
}

TEST_CASE("A narrow gap is less open than the faces around it", "[mesh]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    for (const float low : {-0.23f, 0.03f}) maker.box(matter, {-0.6f, -0.6f, low}, {0.6f, 0.6f, low + 0.2f});
    const Scene scene = maker.make(constant_environment(1));
    Job job(1, 2, kSilent);
    const Outside outside = outside_of(scene.data(), job);
    REQUIRE(outside.openness.size() == outside.mesh.positions.size());
    float inner = 0, outer = 1;
    for (size_t v = 0; v < outside.openness.size(); ++v) {
        const bool in_gap = std::abs(outside.mesh.positions[v].z) < 0.1f;
        in_gap ? inner = std::max(inner, outside.openness[v]) : outer = std::min(outer, outside.openness[v]);
    }
    CAPTURE(inner, outer);
    CHECK(inner < 0.6f * outer);
    CHECK(outer > 0.8f);
}

TEST_CASE("Boxes wound inside out are turned", "[mesh]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {0.5f, -0.5f, -0.5f}, {-0.5f, 0.5f, 0.5f});  // mirrored
    const Scene scene = maker.make(constant_environment(1));
    Job job(1, 2, kSilent);
    const Outside outside = outside_of(scene.data(), job);
    CHECK_FALSE(outside.two_sided);
    const MeshTracer tracer(outside.mesh, Faces::front);
    for (const float x : {-1.0f, 1.0f}) {
        const std::optional<Hit> hit = tracer.closest({{x, 0.01f, 0.02f}, {-x, 0, 0}});
        REQUIRE(hit);
        CHECK(hit->distance < 1);  // the near face
    }
}

TEST_CASE("Sheets are turned whole, however their triangles are wound", "[mesh]")
{
    for (const bool by_chance : {false, true}) {
        const Scene scene = terrain(by_chance);
        Job job(1, 2, kSilent);
        const Outside outside = outside_of(scene.data(), job);
        CHECK(outside.two_sided);
        CHECK(torn_edges(outside.mesh) == 0);
    }
}

TEST_CASE("A small sheet beside a large body has both of its sides", "[mesh]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    maker.quad(matter, {-0.12f, 0.6f, 0.55f}, {0.12f, 0.6f, 0.55f}, {0.12f, 0.6f, 0.8f}, {-0.12f, 0.6f, 0.8f});
    const BuiltMesh built = built_mesh(maker.make(constant_environment(1)), {200, 2, 0.2f});
    CHECK(built.loss.holes == 0);
    CHECK(built.loss.missed < 0.001);
}

TEST_CASE("Sheets that cannot face one way are torn, not lost", "[mesh]")
{
    Mesh strip;  // with half a turn
    for (uint32_t k = 0; k < 6; ++k) {
        const uint32_t a = 2 * k, c = k == 5 ? 1 : a + 2, d = k == 5 ? 0 : a + 3;
        strip.corners.push_back({a, a + 1, c});
        strip.corners.push_back({a + 1, d, c});
    }
    strip.positions.resize(12);
    const Sheets sheets(strip);
    for (uint32_t k = 0; k < 12; ++k) {
        CHECK(sheets.of(k).sheet == sheets.of(0).sheet);
        if (sheets.of(k).reversed) std::swap(strip.corners[k][1], strip.corners[k][2]);
    }
    CHECK(torn_edges(strip) == 1);
}

}  // namespace lumi::baker::testing
