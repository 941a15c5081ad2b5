// SPDX-License-Identifier: MIT
// `lumi inspect` and `lumi embed` of fields whose every byte is known.
#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "lumi/surface/frame.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "surface/gloss_bytes.h"

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

namespace
{

// The programs main.cpp and main.c that include an embedded field's header.
void check_compiles(const test::TemporaryFolder& folder)
{
    for (const auto& [compiler, standard, file] :
         {std::array<std::string, 3>{LUMI_CXX_COMPILER, "-std=c++17", "main.cpp"},
          {LUMI_C_COMPILER, "-std=c99", "main.c"}}) {
        done(test::run_program({compiler, standard, "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I",
                                LUMI_CORE_INCLUDE, "-I", folder.path(), folder / file}));
    }
}

// Parts whose names are no identifiers, or the same one.
void write_mover(const std::string& path)
{
    std::vector<lumi::test::TestPart> parts = lumi::test::three_parts();
    parts[0].name = "second hand";
    parts[1].name = "second-hand";
    parts[2].name = "int";
    write(path, lumi::test::mover_file(lumi::test::mover(lumi::test::ball(1, 0), parts)));
}

// States whose names are no identifiers, or the same one.
void write_lit(const std::string& path)
{
    write(path, lumi::test::lit_ball_file({{"base"}, {"desk lamp"}, {"desk-lamp"}, {"switch"}}));
}

}  // namespace

TEST_CASE("inspect lists lights, and their RAM")
{
    const test::TemporaryFolder folder;
    write_lit(folder / "f.lumi");
    write(folder / "plain.lumi", lumi::test::surface_file(lumi::test::bumpy_ball()));
    CHECK_THAT(lumi({"inspect", folder / "f.lumi"}).out,
               Catch::Contains("  lights        base: their weight is chosen\n") &&
                   Catch::Contains("  lights        desk lamp: their weight is chosen\n"));
    const auto json = [&](const char* name) {
        return nlohmann::json::parse(lumi({"inspect", folder / name, "--json", "--screen", "240x240", "--verify"}).out);
    };
    const auto lit = json("f.lumi"), plain = json("plain.lumi");
    CHECK(lit["states"] == nlohmann::json({"base", "desk lamp", "desk-lamp", "switch"}));
    CHECK(plain["states"].empty());
    const auto ram = [](const nlohmann::json& of) { return of["ram_bytes"]["2x2"]["view"].get<uint32_t>(); };
    CHECK(ram(lit) - ram(plain) == 4 * state_words(4, 0));
}

TEST_CASE("the header of an embedded field names its states, in C and in C++")
{
    const test::TemporaryFolder folder;
    write_lit(folder / "room.lumi");
    REQUIRE(lumi({"embed", folder / "room.lumi", "-o", folder / "room.S"}).code == 0);
    test::write_content(folder / "main.cpp",
                        "#include \"room.h\"\n"
                        "static room_view<lumi::Screen<64, 64, 16>> view;\n"
                        "static_assert(room_states::desk_lamp_2 == 2 && room_state_state_switch == 3, \"\");\n"
                        "bool dims() { return view.set_state(room_states::desk_lamp, 1) == lumi::ViewError::none; }\n");
    test::write_content(folder / "main.c",
                        "#include <lumi/lumi.h>\n#include \"room.h\"\n"
                        "lumi_error dims(lumi_view* view) { return lumi_set_state(view, room_state_base, 1, 2, 3); }\n"
                        "int states[room_light_states];\n");
    check_compiles(folder);
}

TEST_CASE("inspect counts gloss maps and their RAM, and the header of their field has a view that opens it")
{
    const test::TemporaryFolder folder;
    const lumi::test::TestSurface ball = lumi::test::ball_for_gloss();
    write(folder / "ball.lumi", lumi::test::glossy_file(ball, lumi::test::any_gloss(ball)));
    write(folder / "plain.lumi", lumi::test::surface_file(ball));
    CHECK_THAT(lumi({"inspect", folder / "ball.lumi"}).out, Catch::Contains("  gloss         3 maps\n"));
    const auto json = [&](const char* name) {
        return nlohmann::json::parse(lumi({"inspect", folder / name, "--json", "--screen", "240x240"}).out);
    };
    const auto glossy = json("ball.lumi"), plain = json("plain.lumi");
    CHECK(glossy["gloss"] == 3);
    CHECK(plain["gloss"] == 0);
    const auto ram = [](const nlohmann::json& of) { return of["ram_bytes"]["2x2"]["view"].get<uint32_t>(); };
    CHECK(ram(glossy) - ram(plain) == 4 * gloss_words(3, ball.viewed));
    REQUIRE(lumi({"embed", folder / "ball.lumi", "-o", folder / "room.S"}).code == 0);
    test::write_content(folder / "main.cpp",
                        "#include \"room.h\"\n"
                        "static room_view<lumi::Screen<64, 64, 16>> view;\n"
                        "bool opens() { return view.open(room, room_size()) == lumi::ViewError::none; }\n");
    test::write_content(folder / "main.c",
                        "#include <lumi/lumi.h>\n#include \"room.h\"\n"
                        "uint64_t memory[LUMI_GLOSS_MEMORY(room_gloss, room_viewed)];\n");
    check_compiles(folder);
}

TEST_CASE("inspect lists what moves")
{
    const test::TemporaryFolder folder;
    write_mover(folder / "f.lumi");
    const Outcome text = lumi({"inspect", folder / "f.lumi"});
    CHECK_THAT(text.out, Catch::Contains("  moves         second hand: turns, by any angle\n") &&
                             Catch::Contains("  moves         second-hand: turns from -22.5 to 22.5 degrees\n") &&
                             Catch::Contains("  moves         int: slides from -0.0625 to 0.9375 radii\n"));
    const auto json = nlohmann::json::parse(lumi({"inspect", folder / "f.lumi", "--json", "--screen", "64x64"}).out);
    REQUIRE(json["parts"].size() == 3);
    CHECK(json["parts"][0]["name"] == "second hand");
    CHECK(!json["parts"][0].contains("from"));
    CHECK(json["parts"][1]["pivot"][1] == Approx(0.5));
    CHECK(json["parts"][2]["motion"] == "slide");
    CHECK(json["parts"][2]["to"] == Approx(0.9375));
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
    check_compiles(folder);
}

}  // namespace lumi::tools
