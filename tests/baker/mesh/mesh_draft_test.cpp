// SPDX-License-Identifier: MIT
#include "mesh/mesh_draft.h"

#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "mesh/mesh_tracer.h"
#include "mesh/simplify/simplify.h"
#include "mesh/simplify/steps.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

// Upright walls that cross, of many rows of triangles: of each corner some edge belongs to four of these.
Mesh waffle(uint32_t cells, uint32_t rows)
{
    Mesh mesh;
    const auto corner = [&](uint32_t x, uint32_t y, uint32_t z) { return (z * (cells + 1) + y) * (cells + 1) + x; };
    for (uint32_t z = 0; z <= rows; ++z)
        for (uint32_t y = 0; y <= cells; ++y)
            for (uint32_t x = 0; x <= cells; ++x)
                mesh.positions.push_back({0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y),
                                          0.5f * static_cast<float>(z) / static_cast<float>(rows)});
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        mesh.corners.push_back({a, b, c});
        mesh.corners.push_back({a, c, d});
    };
    for (uint32_t z = 0; z < rows; ++z) {
        for (uint32_t k = 0; k <= cells; ++k) {
            for (uint32_t i = 0; i < cells; ++i) {
                add(corner(i, k, z), corner(i + 1, k, z), corner(i + 1, k, z + 1), corner(i, k, z + 1));
                add(corner(k, i, z), corner(k, i + 1, z), corner(k, i + 1, z + 1), corner(k, i, z + 1));
            }
        }
    }
    return mesh;
}

// The surfaces of unit cubes, half of a block's by chance: where two meet in an edge, four triangles do.
Mesh cubes_by_chance()
{
    constexpr int kSide = 10;
    std::mt19937 random(1);
    std::vector<bool> there;
    for (int k = 0; k < kSide * kSide * kSide; ++k) there.push_back(random() % 2 == 0);
    using Place = std::array<int, 3>;
    const auto is_there = [&](const Place& p) {
        const bool inside = std::all_of(p.begin(), p.end(), [](int c) { return c >= 0 && c < kSide; });
        return inside && there[static_cast<size_t>((p[2] * kSide + p[1]) * kSide + p[0])];
    };
    Mesh mesh;
    std::map<Place, uint32_t> numbers;
    const auto vertex = [&](const Place& p) {
        const auto [number, is_new] = numbers.try_emplace(p, static_cast<uint32_t>(mesh.positions.size()));
        const auto place = [](int c) { return static_cast<float>(c) / kSide; };
        if (is_new) mesh.positions.push_back({place(p[0]), place(p[1]), place(p[2])});
        return number->second;
    };
    const auto add_face = [&](Place p, size_t axis, int side) {
        const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        p[axis] += side;
        const uint32_t a = vertex(p), b = (++p[u], vertex(p)), c = (++p[v], vertex(p)), d = (--p[u], vertex(p));
        mesh.corners.push_back(side != 0 ? Mesh::Corners{a, b, c} : Mesh::Corners{a, c, b});
        mesh.corners.push_back(side != 0 ? Mesh::Corners{a, c, d} : Mesh::Corners{a, d, c});
    };
    for (int k = 0; k < kSide * kSide * kSide; ++k) {
        const Place p = {k % kSide, k / kSide % kSide, k / kSide / kSide};
        for (size_t face = 0; is_there(p) && face < 6; ++face) {
            Place beside = p;
            beside[face / 2] += face % 2 != 0 ? 1 : -1;
            if (!is_there(beside)) add_face(p, face / 2, static_cast<int>(face % 2));
        }
    }
    return mesh;
}

}  // namespace

TEST_CASE("Every triangle that is left of surfaces that meet has three vertices", "[mesh]")
{
    const Mesh cubes = cubes_by_chance();
    for (const size_t triangles : {300u, 400u, 500u, 600u}) {
        const Mesh few = simplified(cubes, triangles);
        CHECK(few.triangle_count() > 0);
        for (const Mesh::Corners& c : few.corners) CHECK(!is_degenerate(c));
    }
}

TEST_CASE("Walls that cross are simplified, each for itself, and stay whole", "[mesh]")
{
    const Mesh walls = waffle(3, 40);
    const Mesh simple = simplified(walls, 240);
    CHECK(simple.triangle_count() <= 300);
    CHECK(whole_area(simple) > 0.95 * whole_area(walls));
}

TEST_CASE("Seams between sheets that lie side by side do not gape", "[mesh]")
{
    constexpr uint32_t kSteps = 60;
    constexpr float kGap = 0.004f;  // half a pixel
    Mesh two;
    const auto add_sheet = [&](float inner, float outer) {  // of a bell, around the middle
        const uint32_t first = static_cast<uint32_t>(two.positions.size());
        for (uint32_t ring = 0; ring <= kSteps; ++ring) {
            for (uint32_t step = 0; step < kSteps; ++step) {
                const float r = inner + (outer - inner) * static_cast<float>(ring) / kSteps;
                const float turn = 2 * kPi * static_cast<float>(step) / kSteps;
                two.positions.push_back({r * std::cos(turn), r * std::sin(turn), 0.5f * std::cos(3 * r)});
            }
        }
        for (uint32_t k = 0; k < kSteps * kSteps; ++k) {
            const uint32_t a = first + k, b = first + k / kSteps * kSteps + (k + 1) % kSteps;
            two.corners.push_back({a, a + kSteps, b});
            two.corners.push_back({b, a + kSteps, b + kSteps});
        }
    };
    add_sheet(0.1f, 0.5f);
    add_sheet(0.5f + kGap, 0.9f);
    const Mesh simple = simplified(two, 200);
    CHECK(simple.triangle_count() > 100);
    const MeshTracer tracer(simple, Faces::both);
    uint32_t open = 0;
    for (uint32_t k = 0; k < 360 * 200; ++k) {
        const float turn = 2 * kPi * static_cast<float>(k % 360) / 360, r = 0.4f + 0.001f * static_cast<float>(k / 360);
        open += tracer.closest({{r * std::cos(turn), r * std::sin(turn), 1}, {0, 0, -1}}) ? 0u : 1u;
    }
    CHECK(open == 0);
}

TEST_CASE("A reach that is finer than numbers closes no seam", "[mesh]")
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
    mesh.corners = {{0, 1, 2}, {3, 4, 5}};
    for (const float reach : {0.0f, 1e-30f, 1e-6f}) CHECK(with_closed_seams(mesh, reach).corners == mesh.corners);
    CHECK(with_closed_seams(mesh, 1e-5f).corners != mesh.corners);
}

TEST_CASE("A sheet of very many vertices at one place is passed by", "[mesh]")
{
    constexpr uint32_t kRim = 200000;
    Mesh mesh;  // a disc smaller than the reach, and a triangle beside it: 2 * 10^10 pairs of vertices
    mesh.positions = {{0, 0, 0}, {0.5f, 0, 0}, {0.6f, 0, 0}, {0.5f, 0.1f, 0}};
    mesh.corners = {{1, 2, 3}};
    for (uint32_t k = 0; k < kRim; ++k) {
        const float turn = 2 * kPi * static_cast<float>(k) / kRim;
        mesh.positions.push_back({0.004f * std::cos(turn), 0.004f * std::sin(turn), 0});
        mesh.corners.push_back({0, 4 + k, 4 + (k + 1) % kRim});
    }
    CHECK(with_closed_seams(mesh, 0.01f).corners == mesh.corners);
}

TEST_CASE("Open strips that are narrower than the reach of seams stay", "[mesh]")
{
    constexpr float kWidth = 0.003f, kPeriod = 0.005f;
    Mesh mesh;  // slats of a blind
    for (uint32_t k = 0; k < 200; ++k) {
        const float low = kPeriod * static_cast<float>(k), high = low + kWidth;
        for (const Vec3& p : {Vec3{low, 0, 0}, {high, 0, 0}, {high, 1, 0}, {low, 1, 0}}) mesh.positions.push_back(p);
        mesh.corners.push_back({4 * k, 4 * k + 1, 4 * k + 2});
        mesh.corners.push_back({4 * k, 4 * k + 2, 4 * k + 3});
    }
    const Mesh closed = with_closed_seams(mesh, 1.0f / 120);
    REQUIRE(closed.triangle_count() == mesh.triangle_count());
    for (size_t k = 0; k < mesh.triangle_count(); ++k) CHECK(closed.area(k) > 0.8f * mesh.area(k));
}

TEST_CASE("Wires far thinner than the error elsewhere stay whole", "[mesh]")
{
    constexpr float kThick = 0.004f;  // half a pixel
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.ball(matter, {0, 0, 0}, 0.4f, 64);
    for (int k = 0; k < 8; ++k) {
        const float low = 0.05f * static_cast<float>(k) + 0.5f;
        maker.box(matter, {low, -0.5f, 0}, {low + kThick, 0.5f, kThick});
    }
    maker.span_unit_sphere();
    const Mesh scene = welded(maker.make(constant_environment(1)).data().mesh);
    const auto area_of_wires = [](const Mesh& mesh) {
        double sum = 0;
        for (size_t k = 0; k < mesh.triangle_count(); ++k)
            sum += mesh.position(k, 0).x > 0.45f ? static_cast<double>(mesh.area(k)) : 0;
        return sum;
    };
    const Mesh simple = simplified(scene, 400);
    CHECK(simple.triangle_count() <= 500);
    CHECK(area_of_wires(simple) > 0.8 * area_of_wires(scene));
}

TEST_CASE("Bars whose edges are split do not grow onto the bar beside them", "[mesh]")
{
    constexpr float kLength = 1.8f, kThick = 0.06f, kGap = 0.06f;
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    for (int k = 0; k < 3; ++k) {
        const float low = (kThick + kGap) * static_cast<float>(k - 1);
        maker.box(matter, {-kLength / 2, low, 0}, {kLength / 2, low + kThick, kThick});
    }
    const BuiltMesh bars = built_mesh(maker.make(constant_environment(1)), {36, 0.3f, 0.2f});
    CHECK(bars.mesh.patches.size() > 36);
    CHECK(bars.loss.added < 0.001);
    CHECK(bars.loss.displaced < 0.001);
}

TEST_CASE("A mesh that need not be simplified is not moved either", "[mesh]")
{
    constexpr float kStep = 1.0f / (1 << 14);  // of a field's places
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    for (int k = 0; k < 8; ++k) {  // wires, half a pixel thick
        const float low = 0.15f * static_cast<float>(k) - 0.6f;
        maker.box(matter, {low, -0.7f, 0.02f * low}, {low + 0.004f, 0.7f, 0.02f * low + 0.004f});
    }
    const Scene scene = maker.make(constant_environment(1));
    const Mesh drawn = triangles_of(built_mesh(scene, {200, 0.5f, 0.2f}).mesh);
    for (const Vec3& corner : welded(scene.data().mesh).positions) {
        float nearest = 1;
        for (const Vec3& p : drawn.positions) nearest = std::min(nearest, length(p - corner));
        CHECK(nearest <= kStep);
    }
}

}  // namespace lumi::baker::testing
