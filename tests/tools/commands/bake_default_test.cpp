// SPDX-License-Identifier: MIT
// `lumi bake` chooses these where the user does not.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../../baker/support/nifti_bytes.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::lumi;
using test::Outcome;

namespace
{

std::string layout_of(const std::string& field)
{
    return nlohmann::json::parse(lumi({"inspect", field, "--json"}).out)["layout"];
}

// Specks that few triangles cannot follow.
std::string write_specks(const std::string& folder, int count)
{
    std::ostringstream obj;
    for (int k = 0; k < count; ++k) {
        const double x = k % 10 - 4.5, y = k / 10 % 10 - 4.5, z = k / 100 - 2.5;
        obj << "v " << x << ' ' << y << ' ' << z << "\nv " << x + 0.2 << ' ' << y << ' ' << z << "\nv " << x << ' '
            << y + 0.2 << ' ' << z + 0.1 << "\nf -3 -2 -1\n";
    }
    test::write_content(folder + "/specks.obj", obj.str());
    return folder + "/specks.obj";
}

// A ball of 10 mm whose extinction by mm is `density`.
std::string write_ball(const std::string& folder, const std::string& density)
{
    constexpr int kSide = 12;  // voxels of 2 mm
    const auto value = [](int x, int y, int z) {
        const double dx = x - 5.5, dy = y - 5.5, dz = z - 5.5;
        return 100 - 20 * std::sqrt(dx * dx + dy * dy + dz * dz);
    };
    test::write_content(folder + "/ball.nii", baker::testing::nifti_int16({kSide, kSide, kSide}, value));
    test::write_content(folder + "/ball.json", R"({"volume": {"file": "ball.nii", "transfer": [)"
                                               R"({"value": 0, "density": 0}, {"value": 1, "density": )" +
                                                   density + "}]}}");
    return folder + "/ball.json";
}

}  // namespace

TEST_CASE("bake without a layout writes a surface field beside the working folder's files, and says what it is worth")
{
    const test::TemporaryFolder folder;
    test::write_cube(folder.path());
    const test::Outcome outcome = done(test::run_program(
        {"sh", "-c",
         "cd '" + folder.path() + "' && '" LUMI_PROGRAM "' bake cube.obj --fit 12kB --paths 10 --for rp2040@1fps"}));
    CHECK(layout_of(folder / "cube.lumi") == "surface");
    CHECK(std::filesystem::file_size(folder / "cube.lumi") <= 12'000);
    std::istringstream lines(outcome.out);
    std::vector<std::string> told;
    for (std::string line; std::getline(lines, line);) told.push_back(line);
    REQUIRE(told.size() == 4);
    CHECK_THAT(told[0], Catch::Matches(R"(cube\.lumi: [0-9.]+ kB, (excellent|good|fair|poor) likeness \([0-9.]+ dB\), )"
                                       R"([0-9]+:[0-9]{2})"));
    CHECK_THAT(told[1], Catch::Matches(R"([0-9.]+ kB suffice, 12\.0 kB were allowed; --fill uses them all)"));
    CHECK_THAT(told[2], Catch::StartsWith("RP2040: ") &&
                            Catch::Contains(" frames a second at 240 x 240 pixels (2x2, ") &&
                            Catch::Contains(" kB of RAM"));
    CHECK_THAT(told[3], Catch::StartsWith("next: lumi render cube.lumi"));
    CHECK_THAT(lumi({"inspect", folder / "cube.lumi"}).out,
               Catch::Contains("antialiased ") && Catch::Contains("ESP32"));
}

TEST_CASE("a plan's options bake the planned surface field")
{
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path()), plan = folder / "plan.json";
    REQUIRE(lumi({"bake", scene, "--fit", "12kB", "--plan-only", "--plan", plan}).code == 0);
    const auto json = nlohmann::json::parse(test::content_of(plan));
    CHECK(json["layout"] == "surface");
    CHECK(json["most_bytes"].get<uint64_t>() <= 12'000);
    CHECK_FALSE(std::filesystem::exists(folder / "cube.lumi"));
    std::istringstream options(json["options"].get<std::string>());
    test::Arguments by_hand = {"bake", scene, "--paths", "4", "-o", folder / "a.lumi"};
    for (std::string word; options >> word;) by_hand.push_back(word);
    REQUIRE(lumi(by_hand).code == 0);
    REQUIRE(lumi({"bake", scene, "--paths", "4", "-o", folder / "b.lumi", "--fit", "12kB"}).code == 0);
    CHECK((test::content_of(folder / "a.lumi") == test::content_of(folder / "b.lumi")));
}

TEST_CASE(
    "where light paths miss the mesh, bake takes the layout that shows more, and says why; --layout surface warns")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_specks(folder.path(), 600), field = folder / "f.lumi";
    const test::Outcome chord =
        done(lumi({"bake", scene, "-o", field, "--fit", "30kB", "--plan-only", "--progress", "json"}));
    std::istringstream lines(chord.out);
    std::string first, plan;
    std::getline(lines, first);
    while (plan.find(R"("planned")") == std::string::npos && std::getline(lines, plan)) {
    }
    CHECK(nlohmann::json::parse(first)["state"] == "planning");
    const auto json = nlohmann::json::parse(plan);
    const std::string reason = json["reason"], measured = "measured by small bakes, a surface field shows ";
    CHECK_THAT(reason, Catch::Contains("miss a mesh of") && Catch::Contains("limit 5 %") && Catch::Contains(measured));
    double surface_db = 0, chord_db = 0;
    REQUIRE(std::sscanf(reason.c_str() + reason.find(measured) + measured.size(), "%lf dB and a chord field %lf dB",
                        &surface_db, &chord_db) == 2);
    CHECK(json["layout"] == (surface_db >= chord_db ? "surface" : "chord"));
    const Outcome surface = lumi({"bake", scene, "-o", field, "--fit", "30kB", "--layout", "surface", "--plan-only"});
    INFO(surface.err);
    CHECK(surface.code == 0);
    CHECK_THAT(surface.out, Catch::StartsWith("layout surface: "));
    CHECK_THAT(surface.err, Catch::Contains("warning: of the light paths"));
}

TEST_CASE("of a volume, bake takes a surface field where it looks solid, a chord field of smoke")
{
    const test::TemporaryFolder folder;
    const auto plan = [&](const char* density) {
        const std::string scene = write_ball(folder.path(), density);
        const test::Outcome outcome =
            done(lumi({"bake", scene, "-o", folder / "f.lumi", "--fit", "20kB", "--plan-only"}));
        return outcome;
    };
    const Outcome soft = plan("1.5"), smoke = plan("0.5");
    CHECK_THAT(soft.out, Catch::StartsWith("layout surface: "));
    CHECK_THAT(smoke.out, Catch::StartsWith("layout chord: ") && Catch::Contains("limit 25 %"));
    const Outcome paced = lumi({"bake", folder / "ball.json", "--for", "rp2040@9fps", "--plan-only"});
    check_refused(paced, 1, "planned for a size, not for a rate; give --fit, too, or --layout surface");
}

TEST_CASE("a bake counts what it warns of, the mesh's faults among it")
{
    const test::TemporaryFolder folder;
    const std::string scene = write_specks(folder.path(), 150);
    const Outcome bake = lumi({"bake", scene, "-o", folder / "f.lumi", "--layout", "surface", "--triangles", "150",
                               "--longest-edge", "0.5", "--texel-density", "6", "--paths", "1", "--progress", "json"});
    INFO(bake.err);
    REQUIRE(bake.code == 0);
    size_t told = 0;
    std::istringstream errors(bake.err), lines(bake.out);
    std::string line, last;
    while (std::getline(errors, line)) told += line.rfind("lumi: warning: ", 0) == 0 ? 1u : 0u;
    while (std::getline(lines, line)) last = line;
    CHECK(told > 0);
    CHECK(nlohmann::json::parse(last)["warnings"] == told);
}

TEST_CASE("a draft says that it is one, and chooses its own settings")
{
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path()), field = folder / "f.lumi";
    const test::Outcome outcome = lumi({"bake", scene, "-o", field, "--draft", "--verbose"});
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("a draft: bake it without --draft to ship it\n") &&
                                Catch::Contains("\nlight ") && Catch::Contains(", mesh "));
    CHECK(nlohmann::json::parse(lumi({"inspect", field, "--json"}).out)["draft"] == true);
    CHECK_THAT(lumi({"inspect", field}).out, Catch::Contains("  draft         yes"));
    REQUIRE(lumi({"render", field, "-o", folder / "f.png", "--size", "8x8"}).code == 0);
    CHECK_THAT(lumi({"bake", scene, "-o", field, "--draft", "--paths", "9"}).err,
               Catch::Contains("--draft chooses --paths itself"));
    CHECK(lumi({"bake", scene, "-o", field, "--draft", "--layout", "chord"}).code != 0);
    REQUIRE(lumi({"bake", scene, "-o", field, "--triangles", "20", "--texel-density", "4", "--paths", "4"}).code == 0);
    CHECK(nlohmann::json::parse(lumi({"inspect", field, "--json"}).out)["draft"] == false);
}

TEST_CASE("an option of one layout chooses it")
{
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path()), field = folder / "f.lumi";
    REQUIRE(lumi({"bake", scene, "-o", field, "--origins", "40", "--directions", "40", "--spp", "1"}).code == 0);
    CHECK(layout_of(field) == "chord");
    CHECK(nlohmann::json::parse(lumi({"inspect", field, "--json"}).out)["texel_format"] == "palette8");
    REQUIRE(lumi({"bake", scene, "-o", field, "--triangles", "20", "--texel-density", "4", "--paths", "4"}).code == 0);
    CHECK(layout_of(field) == "surface");
}

}  // namespace lumi::tools
