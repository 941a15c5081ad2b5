// SPDX-License-Identifier: MIT
// `lumi inspect -o` writes meshes of fields whose every byte is known.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "files/output_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "surface/parts_bytes.h"

namespace lumi::tools
{

using test::lumi;
using test::Outcome;

namespace
{

void write(const std::string& path, const lumi::test::Bytes& bytes)
{
    test::write_content(path, std::string(bytes.begin(), bytes.end()));
}

// A square, and a smaller pane above it.
void write_panes(const std::string& path)
{
    const lumi::test::GlassPalette palette{};
    write(path, lumi::test::see_through_file(lumi::test::panes({{8000, -4000, 200}, {4000, 4000, 7}}), 1, palette));
}

void succeed(const test::Arguments& call)
{
    const test::Outcome outcome = done(lumi(call));
    CHECK_THAT(outcome.out, Catch::Contains("CRC-32"));
}

using Place = std::array<double, 3>;

struct Mesh {
    std::vector<Place> vertices;
    std::map<std::string, std::vector<std::array<size_t, 3>>> groups;
};

Mesh mesh_of(const test::TemporaryFolder& folder, const std::string& up)
{
    succeed({"inspect", folder / "f.lumi", "-o", folder / "f.obj", "--up", up});
    Mesh mesh;
    std::istringstream lines(test::content_of(folder / "f.obj"));
    std::string group;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        Place p{};
        std::array<size_t, 3> face{};
        if (kind == "v" && words >> p[0] >> p[1] >> p[2]) mesh.vertices.push_back(p);
        if (kind == "g") words >> group;
        if (kind == "f" && words >> face[0] >> face[1] >> face[2]) mesh.groups[group].push_back(face);
    }
    return mesh;
}

// Twice its area, along an axis.
double facing(const Mesh& mesh, const std::array<size_t, 3>& face, size_t axis)
{
    const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Place &a = mesh.vertices.at(face[0] - 1), &b = mesh.vertices.at(face[1] - 1),
                &c = mesh.vertices.at(face[2] - 1);
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

void check_refused(const test::Arguments& call, int code, const std::string& words)
{
    check_refused(lumi(call), code, words);
}

}  // namespace

TEST_CASE("what a stranger wrote into a field commands no terminal")
{
    const test::TemporaryFolder folder;
    const auto clear_screen = detail::format::four_cc('\x1b', '[', '2', 'J');
    auto sections = test::field_sections({});
    sections.push_back({clear_screen, 0, {'f', 'o', 'u', 'r'}});
    test::write_content(folder / "f.lumi", test::text_of(sections));
    const Outcome text = lumi({"inspect", folder / "f.lumi"}), json = lumi({"inspect", folder / "f.lumi", "--json"});
    CHECK_THAT(text.out, Catch::Contains("?[2J") && !Catch::Contains("\x1b"));
    CHECK_THAT(json.out, Catch::Contains("\\u001b[2J") && !Catch::Contains("\x1b"));
}

TEST_CASE(
    "inspect writes a mesh in the units and axes of the scene, seen from outside, see-through parts by themselves")
{
    constexpr double kRadius = 4, kHalf = kRadius * 8000 / 16384, kDown = kRadius * -4000 / 16384, kDigits = 1e-5;
    const Place centre = {1, 2, 3};  // of TestSurface
    const test::TemporaryFolder folder;
    write_panes(folder / "f.lumi");
    for (const auto& [up, axis] : {std::pair<std::string, size_t>{"y", 1}, {"z", 2}}) {
        INFO("up " << up);
        const Mesh mesh = mesh_of(folder, up);
        REQUIRE(mesh.vertices.size() == 8);
        for (size_t k = 0; k < 3; ++k)
            CHECK(mesh.vertices[0][k] == Approx(centre[k] + (k == axis ? kDown : -kHalf)).margin(kDigits));
        // The second vertex lies along the sphere's x, which is the scene's z where y is up.
        const size_t along = up == "y" ? 2 : 0;
        CHECK(mesh.vertices[1][along] == Approx(centre[along] + kHalf).margin(kDigits));
        REQUIRE(mesh.groups.size() == 2);
        for (const auto& [name, half] : {std::pair<std::string, double>{"opaque", 8000}, {"see_through", 4000}}) {
            const double side = 2 * half * kRadius / 16384;
            REQUIRE(mesh.groups.at(name).size() == 2);
            for (const auto& face : mesh.groups.at(name))
                CHECK(facing(mesh, face, axis) == Approx(side * side).epsilon(kDigits));
        }
    }
}

TEST_CASE("inspect -o says what it cannot write, and leaves what is there")
{
    const test::TemporaryFolder folder;
    const std::string chord = folder / "chord.lumi", surface = folder / "f.lumi", old = folder / "old.obj";
    test::write_content(chord, test::field_bytes({}));
    test::write_content(old, kMeshMark);
    write_panes(surface);
    check_refused({"inspect", chord, "-o", old}, 1, "has no mesh; bake a surface field");
    CHECK(test::content_of(old) == kMeshMark);
    check_refused({"inspect", surface, "-o", folder / "f.stl"}, 2, "takes a mesh (.obj)");
    check_refused({"inspect", surface, "--up", "z"}, 2, "--output");
    std::string damaged = test::content_of(surface);
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    test::write_content(surface, damaged);
    check_refused({"inspect", surface, "-o", old}, 1, "f.lumi");
    CHECK(test::content_of(old) == kMeshMark);
    CHECK(folder.entries() == 3);
}

namespace
{

// Parts whose names are no identifiers, or the same one.
void write_mover(const std::string& path)
{
    std::vector<lumi::test::TestPart> parts = lumi::test::three_parts();
    parts[0].name = "second hand";
    parts[1].name = "second-hand";
    parts[2].name = "int";
    write(path, lumi::test::mover_file(lumi::test::mover(lumi::test::ball(1, 0), parts)));
}

}  // namespace

TEST_CASE("inspect lists what moves, and its mesh has a group for each part")
{
    const test::TemporaryFolder folder;
    write_mover(folder / "f.lumi");
    const Outcome text = lumi({"inspect", folder / "f.lumi"});
    CHECK_THAT(text.out, Catch::Contains("  moves         second hand: turns, by any angle\n") &&
                             Catch::Contains("  moves         second-hand: turns from -22.5 to 22.5 degrees\n") &&
                             Catch::Contains("  moves         int: slides from -0.0625 to 0.9375 radii\n"));
    const auto json = nlohmann::json::parse(lumi({"inspect", folder / "f.lumi", "--json"}).out);
    REQUIRE(json["parts"].size() == 3);
    CHECK(json["parts"][0]["name"] == "second hand");
    CHECK(!json["parts"][0].contains("from"));
    CHECK(json["parts"][1]["pivot"][1] == Approx(0.5));
    CHECK(json["parts"][2]["motion"] == "slide");
    CHECK(json["parts"][2]["to"] == Approx(0.9375));
    const Mesh mesh = mesh_of(folder, "z");
    for (const char* group : {"opaque", "second_hand", "second-hand", "int"}) CHECK(mesh.groups.count(group) == 1);
}

TEST_CASE("the header of an embedded field names its parts, in C and in C++")
{
    const test::TemporaryFolder folder;
    write_mover(folder / "clock.lumi");
    REQUIRE(lumi({"embed", folder / "clock.lumi", "-o", folder / "clock.S"}).code == 0);
    test::write_content(folder / "main.cpp",
                        "#include \"clock.h\"\n"
                        "static clock_view<lumi::Screen<64, 64, 16>> view;\n"
                        "static_assert(clock_parts::second_hand_2 == 1 && clock_part_part_int == 2, \"\");\n"
                        "bool moves() { return view.turn(clock_parts::second_hand, 1) == lumi::ViewError::none &&\n"
                        "    view.slide(clock_parts::part_int, 1) == lumi::ViewError::none; }\n");
    test::write_content(folder / "main.c",
                        "#include <lumi/lumi.h>\n#include \"clock.h\"\n"
                        "lumi_error moves(lumi_view* view) { return lumi_turn(view, clock_part_second_hand, 1); }\n"
                        "int parts[clock_moving_parts];\n");
    for (const auto& [compiler, standard, file] :
         {std::array<std::string, 3>{LUMI_CXX_COMPILER, "-std=c++17", "main.cpp"},
          {LUMI_C_COMPILER, "-std=c99", "main.c"}}) {
        done(test::run_program({compiler, standard, "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I",
                                LUMI_CORE_INCLUDE, "-I", folder.path(), folder / file}));
    }
}

}  // namespace lumi::tools
