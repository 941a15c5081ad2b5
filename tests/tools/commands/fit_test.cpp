// SPDX-License-Identifier: MIT
// These tests hold `lumi bake --fit` to its promises.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::Arguments;
using test::joined;
using test::kScene;
using test::lumi;
using test::Outcome;

namespace
{

Arguments fit(const std::string& output, const Arguments& more)
{
    return joined({"bake", kScene, "-o", output, "--spp", "1"}, more);
}

const Arguments kOriginsByHand = {"--layout", "chord", "--origins", "70"};

}  // namespace

TEST_CASE("a budget, a pace or a set of views that cannot be meant is refused with what it takes")
{
    const test::TemporaryFolder folder;
    const std::string output = folder / "o.lumi";
    const std::vector<std::pair<Arguments, std::string>> calls = {
        {{"--fit", "2XB"}, "2MB, 512KiB or 1500000"},
        {{"--fit", "-1"}, "--fit"},
        {{"--fit", "0"}, "--fit takes a size"},
        {{"--fit", "5GB"}, "below 4 GB"},
        {{"--fit", "MB"}, "--fit takes a size"},
        {{"--fit", "1MB", "--for", "rp2040@30"}, "rp2040@30fps"},
        {{"--for", "rp2040x3@30fps"}, "rp2040x2@30fps for both cores"},
        {{"--fit", "1MB", "--for", "z80@30fps"}, "esp32c3"},
        {{"--fit", "1MB", "--shard", "1/2"}, "--shard does not go with --fit"},
        {{"--fit", "1MB", "--layout", "chord", "--triangles", "64"}, "--layout chord"},
        {{"--plan", folder / "plan.json"}, "belongs to --fit"},
        {{"--for", "rp2040@30fps", "--shard", "1/2"}, "--shard does not go with --for"},
        {{"--for", "rp2040", "--plan-only"}, "belongs to --fit"},
        {{"--for", "rp2040@9fps", "--layout", "chord", "--plan-only"}, "a chord field is planned for a size"},
        {{"--for", "rp2040@9fps", "--layout", "chord", "--plan", folder / "plan.json"}, "--plan needs --fit"},
        {{"--ram", "40kB"}, "belongs to --fit"},
        {{"--fit", "1MB", "--ram", "much"}, "--ram takes a size below 4 GB such as 40kB"},
    };
    for (const auto& [options, hint] : calls) check_refused(lumi(fit(output, options)), 2, hint);
    CHECK(folder.entries() == 0);
}

TEST_CASE("where neither layout fits, one smallest size is named")
{
    const test::TemporaryFolder folder;
    const Outcome outcome = lumi({"bake", kScene, "-o", folder / "o.lumi", "--fit", "900"});
    CHECK(outcome.code == 1);
    const std::string text = outcome.out + outcome.err, words = "the smallest that works takes ";
    const size_t first = text.find(words);
    REQUIRE(first != std::string::npos);
    CHECK(text.find(words, first + 1) == std::string::npos);
    CHECK(folder.entries() == 0);
}

TEST_CASE("a plan alone writes no field, for machines it is JSON lines")
{
    const test::TemporaryFolder folder;
    const test::Outcome outcome =
        done(lumi(joined({"bake", kScene, "--plan-only", "--fit", "40kB", "--progress", "json"}, kOriginsByHand)));
    CHECK(folder.entries() == 0);
    std::istringstream lines(outcome.out);
    size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        CHECK_THAT(nlohmann::json::parse(line)["options"].get<std::string>(),
                   Catch::Contains("--layout chord --origins 70 "));
    CHECK(count == 1);
}

TEST_CASE("a bake for little RAM plans a mesh for it and says what is given up, and where none fits nothing is written")
{
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path()), plan = folder / "plan.json";
    const auto bake = [&](const Arguments& more) {
        return lumi(
            joined({"bake", scene, "--layout", "surface", "--plan-only", "--plan", plan, "--fit", "60kB"}, more));
    };
    REQUIRE(bake({"--ram", "900kB", "--gloss-maps", "0"}).code == 0);
    const auto roomy = nlohmann::json::parse(test::content_of(plan));
    CHECK(roomy["triangles_without_ram"] == 0);
    CHECK(roomy["fewer_maps"] == false);
    const Outcome without_maps = done(bake({"--ram", std::to_string(roomy["ram_bytes"].get<uint64_t>())}));
    CHECK_THAT(without_maps.out, Catch::Contains("of RAM, for which it has no gloss maps"));
    const std::string less = std::to_string(roomy["ram_bytes"].get<uint64_t>() - 4000);
    const Outcome tight = done(bake({"--ram", less}));
    const auto json = nlohmann::json::parse(test::content_of(plan));
    CHECK(json["ram_bytes"] <= roomy["ram_bytes"].get<uint64_t>() - 4000);
    CHECK(json["triangles_without_ram"] == roomy["triangles"]);
    CHECK(json["fewer_maps"] == true);
    CHECK_THAT(tight.out, Catch::Contains("of RAM, for which it has fewer triangles than " +
                                          std::to_string(roomy["triangles"].get<uint32_t>()) + ", and no gloss maps"));
    CHECK_THAT(done(bake({"--ram", less, "--rows", "8", "--progress", "json"})).out,
               Catch::Contains(R"("fewer_maps":false)"));
    CHECK(nlohmann::json::parse(test::content_of(plan))["triangles_without_ram"] == 0);
    const std::string before = test::content_of(plan);
    check_refused(bake({"--ram", "9kB"}), 1, "give more --ram, or fewer --rows");
    CHECK(test::content_of(plan) == before);
    check_refused(lumi({"bake", scene, "-o", folder / "o.lumi", "--layout", "chord", "--fit", "60kB", "--ram", "5kB"}),
                  1, "give more RAM, or fewer --rows");
}

TEST_CASE("a plan for a smaller or larger display names it among the options by hand, for its texels may be as fine")
{
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path());
    const auto planned_for = [&](const std::string& screen) {
        return done(lumi({"bake", scene, "--layout", "surface", "--fit", "60kB", "--plan-only", "--screen", screen}))
            .out;
    };
    CHECK_THAT(planned_for("120x160"), Catch::Contains(" --screen 120x120"));
    CHECK_THAT(planned_for("480x480"), Catch::Contains(" --screen 480x480"));
    CHECK_THAT(planned_for("320x240"), !Catch::Contains(" --screen"));
}

TEST_CASE("a pace names the mode that reaches it, of a chord field too")
{
    const test::TemporaryFolder folder;
    const test::Outcome outcome =
        done(lumi(fit(folder / "o.lumi", joined({"--fit", "20kB", "--for", "rp2350@2fps"}, kOriginsByHand))));
    CHECK_THAT(outcome.out, Catch::Contains("RP2350: ") && Catch::Contains(" frames a second at 240 x 240 pixels ("));
}

TEST_CASE("a surface field is planned for a rate: finely drawn for a low one, else faster, and its neighbours are told")
{
    const test::TemporaryFolder folder;
    const std::string scene = test::write_cube(folder.path());
    const Arguments plan = {"bake",  scene,  "-o",          folder / "o.lumi", "--layout", "surface",
                            "--fit", "15kB", "--plan-only", "--sky",           "gradient", "--for"};
    const auto planned = [&](const std::string& pace) { return done(lumi(joined(plan, {pace}))).out; };
    CHECK_THAT(planned("rp2040@1fps"), Catch::StartsWith("RP2040 at 1 frames a second: antialiased, ") &&
                                           Catch::Contains("is faster: one-sample"));
    CHECK_THAT(planned("rp2040@40fps"), Catch::StartsWith("RP2040 at 40 frames a second: one-sample, ") &&
                                            Catch::Contains("shows more: antialiased"));
    CHECK_THAT(planned("rp2040x2@10fps"),
               Catch::StartsWith("RP2040, both cores, at 10 frames a second: ") && Catch::Contains("layout surface: "));
    CHECK_THAT(done(lumi(joined(plan, {"rp2040@1fps", "--ram", "900kB"}))).err,
               Catch::Contains("with --ram the rate of --for is only reported, not planned for"));
}

}  // namespace lumi::tools
