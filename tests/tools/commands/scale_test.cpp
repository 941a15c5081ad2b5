// SPDX-License-Identifier: MIT
// Bakes that are killed, go on, are cut into shards and merged, as users do it.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "image/picture_file.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::Arguments;
using test::content_of;
using test::joined;
using test::kScene;
using test::lumi;
using test::Outcome;

namespace
{

[[maybe_unused]] constexpr int kKilled = 128 + 9;

Arguments bake(const std::string& output, const Arguments& more = {})
{
    return joined(
        {"bake", kScene, "-o", output, "--origins", "60", "--directions", "80", "--spp", "16", "--texel", "rgb565"},
        more);
}

// Enough writes to be killed in ten times.
[[maybe_unused]] Arguments long_bake(const std::string& output)
{
    return {"bake", kScene,  "-o", output,    "--origins", "200",       "--directions",
            "100",  "--spp", "16", "--texel", "rgb565",    "--threads", "2"};
}

std::vector<nlohmann::json> json_lines(const std::string& text)
{
    std::istringstream lines(text);
    std::vector<nlohmann::json> result;
    for (std::string line; std::getline(lines, line);) result.push_back(nlohmann::json::parse(line));
    return result;
}

}  // namespace

#ifdef LUMI_FAULT_SHIM
namespace
{

Outcome lumi_with(const std::string& fault, const Arguments& arguments)
{
    return test::run_program(joined({"env", "LD_PRELOAD=" LUMI_FAULT_SHIM, fault, LUMI_PROGRAM}, arguments));
}

// How often the program itself does that with files.
int calls_of(const std::string& wanted, const Arguments& arguments)
{
    const test::TemporaryFolder folder;
    REQUIRE(lumi_with("LUMI_FAULT_COUNT=" + (folder / "counts"), arguments).code == 0);
    std::istringstream counts(content_of(folder / "counts"));
    std::string kind;
    int count = 0;
    while (counts >> kind >> count && kind != wanted) continue;
    return count;
}

}  // namespace

TEST_CASE("a rename whose answer was lost has been done")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::small_surface_bytes());
    const Arguments embed = {"embed", folder / "f.lumi", "-o", folder / "o.bin"};
    const Arguments bake = {"bake", kScene,         "-o", folder / "o.lumi", "--origins",
                            "8",    "--directions", "8",  "--spp",           "1"};
    for (const Arguments& call : {embed, bake})
        for (const char* which : {"1", "2"}) done(lumi_with("LUMI_FAULT=rename:" + std::string(which) + ":done", call));
    CHECK(content_of(folder / "o.bin") == content_of(folder / "f.lumi"));
}

TEST_CASE("a scene that takes long to load is told of")
{
    const test::TemporaryFolder folder;
    const Arguments call = {"reference", kScene, "-o", folder / "o.png", "--size", "4x4", "--spp", "1"};
    CHECK_THAT(lumi_with("LUMI_FAULT=read:1:wait", call).err, Catch::Contains("loading the scene  0:02"));
}

TEST_CASE("every command tells of a file that takes long to be read")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::small_surface_bytes());
    write_png(folder / "a.png", Picture(16, 16));
    const std::string shard =
        "bake '" + std::string(kScene) + "' -o s.lumi --origins 8 --directions 8 --spp 1 --shard ";
    const std::string calls[] = {"compare a.png a.png",
                                 "embed f.lumi -o f.S",
                                 "inspect f.lumi",
                                 "render f.lumi -o r.png --size 8x8",
                                 "merge s.lumi.1-of-1.shard -o m.lumi",
                                 "report '" + std::string(kScene) + "' f.lumi --count 1 --size 16 --spp 1"};
    std::string script = "cd '" + folder.path() + "' && " LUMI_PROGRAM " " + shard +
                         "1/1 && export LD_PRELOAD=" LUMI_FAULT_SHIM " LUMI_FAULT=read:1:wait; ";
    for (size_t k = 0; k < std::size(calls); ++k)
        script += LUMI_PROGRAM " " + calls[k] + " >/dev/null 2>" + std::to_string(k) + ".txt & ";
    done(test::run_program({"sh", "-c", script + "wait"}));  // all of them at once
    for (size_t k = 0; k < std::size(calls); ++k) {
        INFO(calls[k]);
        CHECK_THAT(content_of(folder / (std::to_string(k) + ".txt")), Catch::Contains("  0:02"));
    }
}

TEST_CASE("a bake tells of its last work, too, where that takes long")
{
    const test::TemporaryFolder folder;
    const Arguments bake = {"bake", kScene,         "-o", folder / "o.lumi", "--origins",
                            "8",    "--directions", "8",  "--spp",           "1"};
    const std::string last = "LUMI_FAULT=read:" + std::to_string(calls_of("read", bake)) + ":wait";
    CHECK_THAT(lumi_with(last, bake).err, Catch::Contains("drawing poses to time them  0:02"));
}

TEST_CASE("a bake that was killed ten times before random writes is bit-identical to an undisturbed one")
{
    const test::TemporaryFolder folder;
    const std::string whole = folder / "whole.lumi", killed = folder / "killed.lumi";
    const int writes = calls_of("write", long_bake(whole));
    REQUIRE(writes > 160);
    test::write_content(killed, "earlier");
    std::mt19937 random(5);
    std::uniform_int_distribution<int> moment(3, writes / 16);  // all ten together are fewer than the bake's
    for (int k = 0; k < 10; ++k) {
        const std::string fault = "LUMI_FAULT=write:" + std::to_string(moment(random)) + ":kill";
        REQUIRE(lumi_with(fault, long_bake(killed)).code == kKilled);
        CHECK(content_of(killed) == "earlier");
    }
    Arguments again = long_bake(killed);
    again.insert(again.end(), {"--progress", "json"});
    const test::Outcome last = done(lumi(again));
    CHECK(content_of(killed) == content_of(whole));
    CHECK(folder.entries() == 2);
    const auto lines = json_lines(last.out);
    REQUIRE(lines.size() >= 2);
    CHECK(lines.front().at("rays_done") > 0);  // it went on from what the killed ones had done
}

TEST_CASE(
    "a surface bake of which each process is killed before its fifth write is finished all the same, bit-identical")
{
    const test::TemporaryFolder folder;
    const std::string whole = folder / "whole.lumi", killed = folder / "killed.lumi";
    const auto surface_bake = [](const std::string& output) -> Arguments {
        return joined({"bake", kScene, "-o", output, "--threads", "2"}, test::small_surface_options());
    };
    REQUIRE(lumi(surface_bake(whole)).code == 0);
    test::write_content(killed, "earlier");
    constexpr int kMostLives = 60;
    int lives = 1;
    for (; lives < kMostLives; ++lives) {
        const Outcome outcome = lumi_with("LUMI_FAULT=write:5:kill", surface_bake(killed));
        if (outcome.code != kKilled) {
            CHECK(outcome.code == 0);
            break;
        }
        CHECK(content_of(killed) == "earlier");
    }
    CHECK(lives > 2);
    CHECK(lives < kMostLives);
    CHECK(content_of(killed) == content_of(whole));
    CHECK(folder.entries() == 2);
}
#endif

TEST_CASE("json progress writes nothing but JSON to stdout, and ends with what was done")
{
    const test::TemporaryFolder folder;
    const Outcome outcome = lumi(bake(folder / "f.lumi", {"--progress", "json", "--sky", "studio"}));
    const auto lines = json_lines(outcome.out);
    REQUIRE(lines.size() >= 3);
    CHECK(lines.front().at("state") == "baking");
    CHECK(lines.front().at("rays_done") == 0);
    CHECK(lines[lines.size() - 2].at("rays_done") == 60 * 80 * 16);
    CHECK(lines.back().at("state") == "done");
    CHECK(lines.back().at("output") == folder / "f.lumi");
    CHECK(lines.back().at("bytes") == std::filesystem::file_size(folder / "f.lumi"));
    CHECK(lines.back().at("rays_saved") == 0);
    CHECK(outcome.err.empty());
}

TEST_CASE("a bake says how many rays adaptive sampling saved, --adaptive 0 saves none")
{
    const test::TemporaryFolder folder;
    Arguments more = bake(folder / "f.lumi", {"--progress", "json"});
    more[9] = "64";
    const auto lines = json_lines(lumi(more).out);
    CHECK(lines[lines.size() - 2].at("rays_done") == 60 * 80 * 64);
    CHECK(lines.back().at("rays_total") == 60 * 80 * 64);
    CHECK(lines.back().at("rays_saved") > 60 * 80 * 64 / 10);
    more.insert(more.end(), {"--adaptive", "0"});
    CHECK(json_lines(lumi(more).out).back().at("rays_saved") == 0);
    const Arguments for_people = {"bake", kScene,         "-o", folder / "g.lumi", "--origins",
                                  "60",   "--directions", "80", "--spp",           "64"};
    CHECK_THAT(lumi(for_people).out, Catch::Contains(" k light paths saved"));
    CHECK(lumi(bake(folder / "f.lumi", {"--adaptive", "-1"})).code == 2);
}

TEST_CASE("numbers below 0, texts in UTF-16 and pipes are refused by name")
{
    const test::TemporaryFolder folder;
    check_refused(lumi(bake(folder / "f.lumi", {"--seed", "-1"})), 2,
                  Catch::Contains("--seed") &&
                      Catch::Contains("takes a whole number from 0 to 18446744073709551615, not \"-1\""));
    test::write_content(folder / "wide.obj", std::string("\xFF\xFEv\0 \0", 6));
    check_refused(lumi({"bake", folder / "wide.obj", "-o", folder / "f.lumi"}), 1,
                  "wide.obj: this text is in UTF-16; save it in UTF-8");
    std::filesystem::create_directories(folder / "d");
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);  // nobody writes into it
    for (const char* command : {"inspect", "merge"}) {
        Arguments call = {command, folder / "pipe"};
        if (command == std::string("merge")) call.insert(call.end(), {"-o", folder / "f.lumi"});
        check_refused(lumi(call), 1, Catch::Contains("pipe: ") && Catch::Contains("; "));
    }
}

}  // namespace lumi::tools
