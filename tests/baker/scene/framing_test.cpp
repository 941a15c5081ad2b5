// SPDX-License-Identifier: MIT
// One part fills the sphere, and what lies outside of it is cut off where the sphere ends.
#include "scene/framing.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "scene/scene_data.h"
#include "support/obj_files.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

// A tetrahedron of side 1 that stands on a ground of 200 × 200, whose texture coordinates and normals are its places.
const std::string kSmallOnGround =
    "mtllib m.mtl\no small\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 0.3 0.9 0.3\nf 1 2 3\nf 1 4 2\nf 2 4 3\n"
    "f 3 4 1\no ground\nusemtl grey\nv -100 0 -100\nv 100 0 -100\nv 100 0 100\nv -100 0 100\n"
    "vt -100 -100\nvt 100 -100\nvt 100 100\nvt -100 100\nvn 0 1 0\nf 8/4/1 7/3/1 6/2/1 5/1/1\n"
    "o far\nv 90 0 0\nv 91 0 0\nv 90 1 0\nf 9 10 11\n";

Scene framed(const std::string& name)
{
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl grey\nKd 0.5 0.5 0.5\n");
    LoadOptions options;
    options.frame = name;
    std::vector<std::string> warnings;
    return load_scene(folder.write("s.obj", kSmallOnGround), options, warnings);
}

}  // namespace

TEST_CASE("framing: the sphere fits an object, a group or a material, and nothing reaches out of it")
{
    const Scene small = framed("small");
    CHECK(small.radius() < 0.9);
    CHECK(small.radius() > 0.6);
    for (const Vec3& p : small.data().mesh.positions) {
        const auto& corners = small.data().mesh.corners;
        const auto index = static_cast<uint32_t>(&p - small.data().mesh.positions.data());
        const bool used = std::any_of(corners.begin(), corners.end(), [&](const Mesh::Corners& c) {
            return std::find(c.begin(), c.end(), index) != c.end();
        });
        if (used) CHECK(length(p) <= 1);
    }
    CHECK(framed("red").radius() == Approx(small.radius()));
    CHECK(framed("").radius() > 100);
    CHECK(framed("far").radius() < 1);
}

TEST_CASE("framing: a ground ends in a disc where the sphere cuts it, with its own texture coordinates and normals")
{
    const Scene scene = framed("small");
    const Mesh& mesh = scene.data().mesh;
    double area = 0;
    for (size_t t = 4; t < mesh.triangle_count(); ++t) {
        area += static_cast<double>(mesh.area(t));
        CHECK(scene.data().materials[mesh.materials[t]].name == "grey");
        for (size_t k = 0; k < 3; ++k) {
            const Vec3& p = mesh.position(t, k);
            const Vec2& uv = mesh.uvs[static_cast<size_t>(mesh.mapping[t][k])];
            // Scene's x is the sphere's y, and its z the sphere's x.
            CHECK(static_cast<double>(uv.x) == Approx(scene.centre()[0] + scene.radius() * p.y).margin(1e-3));
            CHECK(static_cast<double>(uv.y) == Approx(scene.centre()[2] + scene.radius() * p.x).margin(1e-3));
            CHECK(length(mesh.normals[static_cast<size_t>(mesh.shading[t][k])] - Vec3{0, 0, 1}) < 1e-4f);
        }
    }
    const double height = static_cast<double>(-scene.centre()[1] / scene.radius());
    const double disc = static_cast<double>(kPi) * (1 - height * height);
    CHECK(area < disc);
    CHECK(area > 0.93 * disc);
}

TEST_CASE("framing: a name that nothing has is refused with those that there are")
{
    CHECK_THROWS_WITH(framed("Small"),
                      Catch::Contains("s.obj: ") && Catch::Contains("'Small' (did you mean small?); choose among: far, "
                                                                    "grey, ground, red, small"));
}

TEST_CASE("framing: a group ends at the next group or object, and a file of scenes keeps the names of its models")
{
    const ScratchFolder folder;
    const std::string far = "v 50 0 0\nv 51 0 0\nv 50 1 0\nv 50 0 7\n";
    folder.write("s.obj", std::string(testing::kCorners) + far + "g a\nf 1 2 3\ng b\nf 5 6 7\no c\nf 5 6 8\n");
    const std::filesystem::path json = folder.write("s.json", R"({"objects": [{"obj": "s.obj"}, {"obj": "s.obj"}]})");
    const auto radius = [&](const std::filesystem::path& file, const std::string& name) {
        LoadOptions options;
        options.frame = name;
        std::vector<std::string> warnings;
        return static_cast<double>(load_scene(file, options, warnings).radius());
    };
    for (const std::filesystem::path& file : {folder.at("s.obj"), json}) {
        CHECK(radius(file, "a") == Approx(1.02 * std::sqrt(0.5)).epsilon(1e-3));
        CHECK(radius(file, "b") == Approx(1.02 * std::sqrt(0.5)).epsilon(1e-3));
        CHECK(radius(file, "c") > 3);
    }
}

}  // namespace lumi::baker
