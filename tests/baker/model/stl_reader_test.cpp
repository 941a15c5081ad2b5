// SPDX-License-Identifier: MIT
#include "model/readers.h"

#include <catch2/catch.hpp>

#include <limits>

#include "lumi/baker/scene.h"
#include "support/facet_bytes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{
namespace
{

using testing::ScratchFolder;

SceneParts load_stl(const std::string& bytes, std::string* said = nullptr)
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    SceneParts parts = read_stl(folder.write("m.stl", bytes), warnings);
    if (said)
        for (const std::string& w : warnings) *said += w + "\n";
    return parts;
}

void check_stl_refused(const std::string& bytes, const std::string& what)
{
    CHECK_THROWS_WITH(load_stl(bytes), Catch::Contains("m.stl") && Catch::Contains(what) && Catch::Contains("; "));
}

// A strip of facets around an axis, like a cylinder's side, in steps of so many degrees.
std::string strip(double step_degrees)
{
    std::string text = "solid s\n";
    for (int k = 0; k < 4; ++k) {
        const auto vertex = [&](int step, int z) {
            const double angle = (k + step) * step_degrees * 3.14159265358979 / 180;
            return "vertex " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " " +
                   std::to_string(z) + "\n";
        };
        text += "facet\nouter loop\n" + vertex(0, 0) + vertex(1, 0) + vertex(1, 1) + "endloop\nendfacet\n";
        text += "facet\nouter loop\n" + vertex(0, 0) + vertex(1, 1) + vertex(0, 1) + "endloop\nendfacet\n";
    }
    return text + "endsolid\n";
}

}  // namespace

TEST_CASE("STL: text and binary are the same body, z is up, and its name is that of its material")
{
    for (const std::string& bytes : {testing::text_stl(), testing::binary_stl()}) {
        const SceneParts parts = load_stl(bytes);
        CHECK(parts.mesh.triangle_count() == 4);
        CHECK(parts.mesh.area_vector(0).z > 0);
        CHECK(parts.up == UpAxis::z);
        REQUIRE(parts.materials.size() == 1);
        CHECK(parts.materials[0].name == "m");
    }
    std::string header = testing::binary_stl();
    header.replace(0, 5, "solid");  // many programs begin binary files so
    CHECK(load_stl(header).mesh.triangle_count() == 4);
}

TEST_CASE("STL: facets that turn less than 30 degrees are smooth, others keep their edges")
{
    const auto normals_at_second_edge = [](const SceneParts& parts) {
        const Mesh& m = parts.mesh;  // corner 1 of facet 0, corner 0 of facet 2: the same place
        return dot(m.normals[static_cast<size_t>(m.shading[0][1])], m.normals[static_cast<size_t>(m.shading[2][0])]);
    };
    CHECK(normals_at_second_edge(load_stl(strip(29))) == Approx(1));
    CHECK(normals_at_second_edge(load_stl(strip(31))) == Approx(std::cos(31 * 3.14159265358979 / 180)).margin(1e-4));
}

TEST_CASE("STL: bodies of any size are smooth")
{
    for (const float scale : {1e-14f, 1e14f}) {
        std::vector<testing::TestVertex> vertices = testing::kPyramid;
        for (testing::TestVertex& v : vertices) v = {v.x * scale, v.y * scale, v.z * scale / 10, v.colour};
        const Mesh mesh = load_stl(testing::binary_stl(vertices)).mesh;
        REQUIRE(mesh.triangle_count() == 4);
        CHECK(mesh.normals[static_cast<size_t>(mesh.shading[0][2])].z == Approx(1));
    }
}

TEST_CASE("STL: a file that is cut anywhere is refused")
{
    const std::string binary = testing::binary_stl(), text = testing::text_stl();
    for (size_t size = 0; size < binary.size(); ++size) check_stl_refused(binary.substr(0, size), "");
    for (size_t size = 0; size < text.find("endsolid") + 8; ++size) {
        INFO(size);
        check_stl_refused(text.substr(0, size), "");
    }
}

TEST_CASE("STL: what claims a billion facets, or has no finite corners, is refused")
{
    std::string many = testing::binary_stl();
    many.replace(80, 4, testing::bytes_of_number(uint32_t{1'000'000'000}));
    check_stl_refused(many, "needs 50000000084");
    std::vector<testing::TestVertex> vertices = testing::kPyramid;
    vertices[1].y = std::numeric_limits<float>::quiet_NaN();
    check_stl_refused(testing::binary_stl(vertices), "facet 1 has a coordinate");
    vertices[1].y = 1e30f;
    check_stl_refused(testing::binary_stl(vertices), "facet 1 has a coordinate");
    check_stl_refused("solid\nfacet\nouter loop\nvertex 0 nan 0\n", "m.stl:4: 'nan'");
    check_stl_refused("solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\n", "m.stl:5: a facet of 1 corners");
    check_stl_refused("solid\nbanana\nendsolid\n", "'banana'");
    check_stl_refused("solid\nendsolid\n", "no facet");
}

TEST_CASE("STL: facets without an area cost one warning with their count")
{
    std::string said, text = testing::text_stl();
    const std::string flat = "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 2 0 0\nendloop\nendfacet\n";
    text.insert(text.find("endsolid"), flat + flat);
    CHECK(load_stl(text, &said).mesh.triangle_count() == 4);
    CHECK_THAT(said, Catch::Contains("m.stl: 2 triangle(s) have no area"));
}

}  // namespace lumi::baker
