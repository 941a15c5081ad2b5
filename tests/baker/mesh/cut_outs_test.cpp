// SPDX-License-Identifier: MIT
#include "mesh/cut_outs.h"

#include <catch2/catch.hpp>

#include "mesh/see_through.h"
#include "support/picture_bytes.h"
#include "support/scratch_folder.h"
#include "support/surfaces.h"

namespace lumi::baker::testing
{
namespace
{

constexpr int kPixels = 64;

// A square of side 2 in the plane z = 0, the origin at its middle, beside a smaller one that has no picture.
constexpr char kLeaf[] =
    "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 1 -.5 0\nv 2 -.5 0\nv 2 .5 0\nv 1 .5 0\nvt 0 0\nvt 1 0\n"
    "vt 1 1\nvt 0 1\nusemtl leaf\nf 1/1 2/2 3/3 4/4\nusemtl stem\nf 5 6 7 8\n";

// Opaque up to the radius, in halves of the picture, with a soft rim.
std::string disc(float radius)
{
    std::vector<uint8_t> rgb;
    for (int k = 0; k < kPixels * kPixels; ++k) {
        const auto place = [](int at) { return (2 * static_cast<float>(at) + 1) / kPixels - 1; };
        const float inside = (radius - std::hypot(place(k % kPixels), place(k / kPixels))) * kPixels / 4 + 0.5f;
        rgb.insert(rgb.end(), 3, static_cast<uint8_t>(std::lround(255 * std::clamp(inside, 0.0f, 1.0f))));
    }
    return rgb_png(kPixels, rgb);
}

// Bars that are two pixels wide, with gaps as wide between them.
std::string comb()
{
    std::vector<uint8_t> rgb;
    for (int k = 0; k < kPixels * kPixels; ++k) rgb.insert(rgb.end(), 3, k % 4 < 2 ? 255 : 0);
    return rgb_png(kPixels, rgb);
}

Scene leaf_of(const std::string& png)
{
    const ScratchFolder folder;
    folder.write("m.mtl", "newmtl leaf\nKd .1 .5 .1\nmap_d t.png\nnewmtl stem\nKd .3 .2 .1\n");
    folder.write("t.png", png);
    LoadOptions options;
    options.up = UpAxis::z;
    std::vector<std::string> warnings;
    return load_scene(folder.write("s.obj", kLeaf), options, warnings);
}

Scene leaf(float radius)
{
    return leaf_of(disc(radius));
}

double area_of(const Mesh& mesh)
{
    double area = 0;
    for (size_t k = 0; k < mesh.triangle_count(); ++k) area += static_cast<double>(mesh.area(k));
    return area;
}

}  // namespace

TEST_CASE("A picture of opacity cuts triangles along its contour", "[mesh]")
{
    constexpr float kRadius = 0.7f;
    const Scene scene = leaf(kRadius);
    const std::optional<Mesh> cut = cut_out(scene.data());
    REQUIRE(cut);
    const auto unit = static_cast<double>(scene.radius());
    // Linear interpolation between cells of 1/64 of the square loses less than the picture's own pixels.
    CHECK(area_of(*cut) * unit * unit == Approx(1 + 3.14159265 * 0.7 * 0.7).epsilon(0.005));
    const Vec3 middle = (scene.data().mesh.positions[0] + scene.data().mesh.positions[2]) * 0.5f;
    for (size_t k = 0; k < cut->triangle_count(); ++k) {
        const float x = (cut->position(k, 0).x - middle.x) * scene.radius();
        CHECK((x >= 0.999f || length(cut->position(k, 0) - middle) * scene.radius() < kRadius + 0.01f));
    }
}

TEST_CASE("A picture's cut is about as long as its contour", "[mesh]")
{
    constexpr float kRadius = 0.7f;
    const Scene scene = leaf(kRadius);
    const std::vector<float> lengths = cut_lengths(scene.data());
    REQUIRE(lengths.size() == 2);
    CHECK(lengths[0] * scene.radius() == Approx(2 * 3.14159265f * kRadius).epsilon(0.15));
    CHECK(lengths[1] == 0);
}

TEST_CASE("A picture whose contour a mesh can follow cuts, and any other one is coverage", "[mesh]")
{
    CHECK((see_through_materials(leaf(0.7f).data()) == std::vector<bool>{false, false}));
    CHECK((see_through_materials(leaf_of(comb()).data()) == std::vector<bool>{true, false}));
    CHECK_FALSE(opaque_part(leaf(0.7f).data()));
    const Scene scene = leaf_of(comb());
    REQUIRE(opaque_part(scene.data()));
    CHECK(opaque_part(scene.data())->mesh.triangle_count() == 2);  // the stem
}

TEST_CASE("Opaque pictures and scenes without any leave triangles whole", "[mesh]")
{
    const Scene whole = leaf(2);
    CHECK(cut_out(whole.data())->triangle_count() == whole.triangle_count());
    CHECK(leaf(2).data().materials.size() == 2);
}

TEST_CASE("Surface meshes follow the outlines of cut-out leaves", "[mesh][surface]")
{
    const BuiltMesh surface = built_mesh(leaf(0.7f), {400, 0.2f, 0.7f});
    INFO("added " << surface.loss.added << ", missed " << surface.loss.missed);
    CHECK(surface.loss.added < 0.02);
    CHECK(surface.loss.missed < 0.02);
    CHECK(surface.loss.holes == 0);
    CHECK(triangles_of(surface.mesh).triangle_count() / 2 < 2000);  // of each of the two sides
}

}  // namespace lumi::baker::testing
