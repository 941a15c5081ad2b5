// SPDX-License-Identifier: MIT
// Guided bakes that are killed, go on, are cut into shards and merged, as users do it.
#include <catch2/catch.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace lumi::tools
{

using test::Arguments;
using test::content_of;
using test::lumi;
using test::Outcome;

namespace
{

constexpr int kKilled = 128 + 9;

Arguments bake(const std::string& output, const std::string& layout, const Arguments& more = {})
{
    Arguments all = {"bake", LUMI_TEST_SCENE, "-o", output, "--layout", layout, "--origins", "64"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

Arguments quick(const std::string& layout)
{
    Arguments all = {"--chart", "12", "--spp", "4"};
    if (layout == "guided") all.insert(all.end(), {"--proxy-triangles", "100", "--mean-resolution", "16"});
    return all;
}

// Enough work to be killed in ten times, little of it before the first ray.
Arguments slow(const std::string& layout)
{
    Arguments all = quick(layout);
    all[1] = "40";
    all[3] = "24";
    all.insert(all.end(), {"--threads", "2"});
    return all;
}

nlohmann::json first_with_rays(const std::string& text)
{
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json json = nlohmann::json::parse(line);
        if (json.value("rays_total", 0.0) > 1) return json;
    }
    return {};
}

}  // namespace

TEST_CASE("a guided bake that was killed ten times at random moments is bit-identical to an undisturbed one")
{
    for (const std::string layout : {"guided", "focus"}) {
        const test::TemporaryFolder folder;
        const std::string whole = folder / "whole.lumi", killed = folder / "killed.lumi";
        const auto start = std::chrono::steady_clock::now();
        REQUIRE(lumi(bake(whole, layout, slow(layout))).code == 0);
        const std::chrono::duration<double, std::milli> undisturbed = std::chrono::steady_clock::now() - start;
        test::write_content(killed, "earlier");
        std::mt19937 random(5);
        const Arguments call = bake(killed, layout, slow(layout));
        for (int k = 0; k < 10; ++k) {
            // All ten together are shorter than the bake: none comes too late.
            std::uniform_real_distribution<double> moment(0, undisturbed.count() / 16);
            const auto after = std::chrono::milliseconds(static_cast<int>(moment(random)));
            REQUIRE(test::lumi_killed(call, after).code == kKilled);
            CHECK(content_of(killed) == "earlier");
        }
        Arguments again = call;
        again.back() = "1";
        again.insert(again.end(), {"--progress", "json"});
        const Outcome last = lumi(again);
        INFO(layout << "\n" << last.err);
        REQUIRE(last.code == 0);
        CHECK(content_of(killed) == content_of(whole));
        CHECK(folder.entries() == 2);
        CHECK(first_with_rays(last.out).at("rays_done") > 0);  // it went on from what the killed ones had done
    }
}

TEST_CASE("a guided bake that was interrupted says that it goes on, and does; --restart bakes anew")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "f.lumi";
    Arguments endless = bake(field, "focus", {"--chart", "40", "--spp", "1000000"});
    const Outcome interrupted = test::lumi_interrupted(endless);
    CHECK(interrupted.code == 130);
    CHECK_THAT(interrupted.err, Catch::Contains("f.lumi.part keeps the finished rows; the same command goes on"));
    CHECK(folder.entries() == 1);
    const Arguments other = bake(field, "focus", quick("focus"));
    const Outcome refused = lumi(other);
    CHECK(refused.code == 1);
    CHECK_THAT(refused.err, Catch::Contains("f.lumi.part: holds the finished rows of another bake (other chart: 40 "
                                            "there, 12 here)") &&
                                Catch::Contains("--restart"));
    Arguments anew = other;
    anew.push_back("--restart");
    CHECK(lumi(anew).code == 0);
    CHECK(folder.entries() == 1);
}

TEST_CASE("shards of guided bakes merge to the bytes of one bake")
{
    for (const std::string layout : {"guided", "focus"}) {
        const test::TemporaryFolder folder;
        REQUIRE(lumi(bake(folder / "one.lumi", layout, quick(layout))).code == 0);
        Arguments merge = {"merge", "-o", folder / "merged.lumi"};
        for (const char* shard : {"1/3", "2/3", "3/3"}) {
            Arguments call = bake(folder / "f.lumi", layout, quick(layout));
            call.insert(call.end(), {"--shard", shard});
            const Outcome outcome = lumi(call);
            INFO(outcome.err);
            REQUIRE(outcome.code == 0);
            CHECK_THAT(outcome.out, Catch::Contains("of-3.shard: "));
            merge.push_back(folder / "f.lumi." + shard[0] + "-of-3.shard");
        }
        const Outcome merged = lumi(merge);
        INFO(merged.err);
        CHECK_THAT(merged.out, Catch::Contains("64 x 12 x 12 charts from 3 shards"));
        CHECK(content_of(folder / "merged.lumi") == content_of(folder / "one.lumi"));
        merge.pop_back();
        const Outcome refused = lumi(merge);
        CHECK(refused.code == 1);
        CHECK_THAT(refused.err, Catch::Contains("lumi: shard 3 of 3 is missing; bake it with --shard 3/3"));
    }
}

TEST_CASE("options that guided bakes have no use for are refused by name")
{
    const test::TemporaryFolder folder;
    for (const std::string option : {"--adaptive", "--directions"}) {
        const Outcome refused = lumi(bake(folder / "f.lumi", "guided", {option, "2"}));
        CHECK(refused.code == 2);
        CHECK_THAT(refused.err, Catch::Contains(option + " does not go with --layout guided"));
    }
    CHECK(folder.entries() == 0);
}

}  // namespace lumi::tools
