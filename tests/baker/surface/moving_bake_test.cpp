// SPDX-License-Identifier: MIT
// Fields whose parts move: what any pose shows is there, and no light stays where a part was.
#include <algorithm>
#include <catch2/catch.hpp>

#include "fit/sample_tracer.h"
#include "support/surfaces.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

PartMovement turning(const std::string& name, const Vec3& axis, const Vec3& pivot)
{
    PartMovement movement;
    movement.name = name;
    movement.axis = axis;
    movement.pivot = pivot;
    return movement;
}

// A box without a top, with a bright floor inside, and a lid that lies on it and turns about one of its edges; it is
// lit as it lies there.
Scene lidded_box(std::optional<double> lit_at = 0)
{
    SceneMaker maker;
    const uint32_t wood = maker.add(diffuse({0.5f, 0.3f, 0.1f})), white = maker.add(diffuse(grey(0.8f)));
    constexpr float kSide = 0.4f, kThick = 0.05f, kHigh = 0.2f;
    maker.box(wood, {-kSide, -kSide, -kHigh}, {kSide, -kSide + kThick, kHigh});
    maker.box(wood, {-kSide, kSide - kThick, -kHigh}, {kSide, kSide, kHigh});
    maker.box(wood, {-kSide, -kSide, -kHigh}, {-kSide + kThick, kSide, kHigh});
    maker.box(wood, {kSide - kThick, -kSide, -kHigh}, {kSide, kSide, kHigh});
    maker.box(white, {-kSide, -kSide, -kHigh}, {kSide, kSide, -kHigh + kThick});
    PartMovement lid = turning("lid", {0, 1, 0}, {-kSide, 0, kHigh});
    lid.lit_at = lit_at;
    maker.begin_part(lid);
    maker.box(wood, {-kSide, -kSide, kHigh}, {kSide, kSide, kHigh + kThick});
    return maker.make(constant_environment(1));
}

// By owner: the area of what faces the direction.
double area_facing(const PatchMesh& mesh, uint32_t owner, const Vec3& direction)
{
    std::vector<uint32_t> numbers;
    const Mesh part = triangles_of(mesh, owner, numbers);
    double area = 0;
    for (size_t t = 0; t < part.triangle_count(); ++t) {
        const Vec3 vector = part.area_vector(t);
        if (dot(normalized(vector), direction) > 0.9f) area += static_cast<double>(part.area(t));
    }
    return area;
}

MeshSettings coarse()
{
    MeshSettings settings;
    settings.triangles = 400;
    settings.longest_edge = 0.6f;
    return settings;
}

}  // namespace

TEST_CASE("moving bake: what a lid hides is in the mesh, and both of the lid's sides are")
{
    const Scene scene = lidded_box();
    const double unit = 1 / static_cast<double>(scene.radius() * scene.radius()), inside = 0.49 * unit;
    const PatchMesh mesh = built_mesh(scene, coarse()).mesh;
    REQUIRE(mesh.parts.size() == 1);
    CHECK(mesh.parts[0].name == "lid");
    CHECK(mesh.owner_of(mesh.parts[0].first_patch - 1) == 0);
    CHECK(mesh.owner_of(mesh.parts[0].first_patch) == 1);
    // The rims of the walls, and the floor.
    CHECK(area_facing(mesh, 0, {0, 0, 1}) == Approx(0.8 * unit).epsilon(0.02));
    CHECK(area_facing(mesh, 0, {0, 0, 1}) > inside);
    for (const float side : {1.0f, -1.0f})
        CHECK(area_facing(mesh, 1, {0, 0, side}) == Approx(0.64 * unit).epsilon(0.02));
}

TEST_CASE("moving bake: parts share no vertex with the body")
{
    const PatchMesh mesh = built_mesh(lidded_box(), coarse()).mesh;
    std::vector<uint32_t> owners(mesh.positions.size(), UINT32_MAX);
    for (uint32_t p = 0; p < mesh.patches.size(); ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        for (const uint32_t v : {patch.a, patch.b, patch.c, patch.d}) {
            if (v == PatchMesh::kNone) continue;
            CHECK((owners[v] == UINT32_MAX || owners[v] == mesh.owner_of(p)));
            owners[v] = mesh.owner_of(p);
        }
    }
}

namespace
{

// The light of an owner's faces that look so, at a height.
double mean_light(const Scene& scene, uint32_t owner, const Vec3& facing, float height)
{
    const PatchMesh mesh = built_mesh(scene, coarse()).mesh;
    const FitShape shape(mesh, std::vector<float>(mesh.patches.size(), 4));
    const SampleTracer tracer(scene.data(), shape);
    double sum = 0, count = 0;
    for (uint32_t p = mesh.first_patch(owner); p < mesh.first_patch(owner + 1); ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        const Vec3& a = mesh.positions[patch.a];
        const Vec3 normal = normalized(cross(mesh.positions[patch.b] - a, mesh.positions[patch.c] - a));
        if (dot(normal, facing) < 0.9f || std::abs(a.z * scene.radius() + scene.centre()[2] - height) > 0.02f) continue;
        std::vector<FitSample> samples;
        for (uint32_t texel = 0; texel < shape.layout.rectangles[p].size(); ++texel)
            tracer.trace(1, p, texel, 64, samples);
        for (const FitSample& s : samples) sum += static_cast<double>(s.radiance.g);
        count += static_cast<double>(samples.size());
    }
    REQUIRE(count > 100);
    return sum / count;
}

}  // namespace

TEST_CASE("moving bake: the body is lit as if parts were not there, and parts as they lie on it")
{
    const Scene scene = lidded_box();
    CHECK(mean_light(scene, 0, {0, 0, 1}, -0.15f) > 0.35);  // of 0.8 in the open
    CHECK(mean_light(scene, 1, {0, 0, 1}, 0.25f) == Approx(0.3).epsilon(0.05));
    CHECK(mean_light(scene, 1, {0, 0, -1}, 0.2f) < 0.02);  // it closes the box
}

TEST_CASE("moving bake: without a pose to be lit in, a part has the mean light of those in which it is seen")
{
    const auto under = [](std::optional<double> pose) { return mean_light(lidded_box(pose), 1, {0, 0, -1}, 0.2f); };
    CHECK(under(0) < 0.02);  // the lid is closed, and nobody sees this side
    CHECK(under(std::nullopt) > 0.9 * under(180));
}

TEST_CASE("moving bake: a part turns below its light where most of it lies across its axis")
{
    CHECK(!built_mesh(lidded_box(), coarse()).mesh.parts[0].light_stays);
    SceneMaker maker;
    maker.box(maker.add(diffuse(grey(0.5f))), {-0.5f, -0.5f, -0.1f}, {0.5f, 0.5f, 0});
    maker.begin_part(turning("hand", {0, 0, 1}, {}));
    maker.box(maker.add(diffuse(grey(0.1f))), {-0.05f, -0.05f, 0.05f}, {0.05f, 0.4f, 0.07f});
    CHECK(built_mesh(maker.make(constant_environment(1)), coarse()).mesh.parts[0].light_stays);
}

TEST_CASE("moving bake: a field has its parts, and its bytes do not depend on threads")
{
    SurfaceSettings settings = tiny_surface();
    const Scene scene = lidded_box();
    const std::string one = baked(scene, settings);
    settings.threads = 2;
    CHECK(baked(scene, settings) == one);
    const auto* bytes = reinterpret_cast<const uint8_t*>(one.data());
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bytes, one.size(), field) == FieldError::none);
    REQUIRE(field.part_count == 1);
    const PartName name = part_name(field, 0);
    CHECK(std::string(name.text, name.bytes) == "lid");
    SurfaceField plain;
    CHECK(open_surface(bytes, one.size(), plain) == FieldError::parts);
}

}  // namespace lumi::baker::testing
