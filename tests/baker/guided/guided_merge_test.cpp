// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "guided/guided_scenes.h"
#include "store/block_file.h"
#include "support/merge_problems.h"

namespace lumi::baker
{

using namespace testing;

namespace
{

Paths bake_shards(const ScratchFolder& folder, const Scene& scene, const GuidedSettings& settings, uint32_t count)
{
    Paths shards;
    for (uint32_t k = 1; k <= count; ++k) {
        shards.push_back(folder.at(std::to_string(k) + ".shard"));
        bake_guided_shard(scene, settings, {k, count}, shards.back());
    }
    return shards;
}

}  // namespace

TEST_CASE("guided merge: shards give the bytes of one bake, of every kind and for any number of them", "[repeated]")
{
    const Scene scene = tiny_scene();
    for (const GuidedSettings& settings : tiny_guided_of_every_kind()) {
        const std::string whole = baked(scene, settings);
        for (const uint32_t count : {1u, 3u, 7u}) {
            const ScratchFolder folder;
            Paths shards = bake_shards(folder, scene, settings, count);
            std::reverse(shards.begin(), shards.end());
            const MergedField field = merge_shards(shards, folder.at("f.lumi"));
            INFO(count << " shards");
            CHECK(read_bytes(folder.at("f.lumi")) == whole);
            CHECK(field.bytes == whole.size());
            CHECK(field.shards == count);
            CHECK(field.chart_size == settings.chart_size);
            CHECK(folder.file_count() == count + 1);
        }
    }
}

TEST_CASE("guided shard: one that was stopped goes on; a complete one is left alone; damage is mended", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    const GuidedSettings settings = tiny_guided();
    const Paths whole = bake_shards(folder, scene, settings, 2);
    CHECK_THROWS_AS(bake_guided_shard(scene, settings, {2, 2}, folder.at("s"), stop_after(1)), Cancelled);
    CHECK_THROWS_WITH(bake_guided_shard(scene, settings, {1, 2}, folder.at("s")), Catch::Contains("another shard"));
    bake_guided_shard(scene, settings, {2, 2}, folder.at("s"));
    CHECK(read_bytes(folder.at("s")) == read_bytes(whole[1]));
    int calls = 0;
    const ProgressCallback count_calls = [&](const Progress&) { return ++calls > 0; };
    bake_guided_shard(scene, settings, {2, 2}, folder.at("s"), count_calls);
    CHECK(calls == 0);
    for (const size_t at : {kHeadBytes + 5, read_bytes(whole[1]).size() - 3}) {
        std::string damaged = read_bytes(whole[1]);
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        folder.write("s", damaged);
        bake_guided_shard(scene, settings, {2, 2}, folder.at("s"), count_calls);
        CHECK(calls > 0);
        CHECK(read_bytes(folder.at("s")) == read_bytes(whole[1]));
    }
    CHECK(folder.file_count() == 3);
}

TEST_CASE("guided merge: missing, double, foreign, damaged and unfinished shards are each named")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    const Paths shard = bake_shards(folder, scene, tiny_focus(), 2);
    using Catch::Contains;

    auto problems = problems_of(folder, {shard[0]});
    REQUIRE(problems.size() == 1);
    CHECK(problems[0] == "shard 2 of 2 is missing; bake it with --shard 2/2");
    problems = problems_of(folder, {shard[0], shard[1], folder.write("copy", read_bytes(shard[1]))});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Contains("copy: is shard 2, as "));

    GuidedSettings other = tiny_focus();
    other.samples = 3;
    bake_guided_shard(scene, other, {2, 2}, folder.at("foreign"));
    problems = problems_of(folder, {shard[0], shard[1], folder.at("foreign")});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Contains("foreign: belongs to another bake") && Contains("other samples: 3 there, 2 here"));
    bake_shard(scene, tiny_settings(), {2, 2}, folder.at("chord"));
    problems = problems_of(folder, {shard[0], shard[1], folder.at("chord")});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Contains("other layout: chord there, focus here"));

    std::string damaged = read_bytes(shard[1]);
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    problems = problems_of(folder, {shard[0], folder.write("damaged", damaged)});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Contains("damaged: 1 of ") && Contains("rows are missing or damaged"));
    CHECK_THROWS_AS(bake_guided_shard(scene, tiny_focus(), {2, 2}, folder.at("u"), stop_after(0)), Cancelled);
    problems = problems_of(folder, {shard[0], folder.at("u.part")});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Contains("u.part: "));
    CHECK_THROWS_WITH(merge_shards(shard, shard[1]), Contains("is one of the shards"));
}

TEST_CASE("guided merge: every truncation and every damaged byte of a shard is refused by name")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    const Paths shard = bake_shards(folder, scene, tiny_focus(), 2);
    const std::string whole = read_bytes(shard[0]);
    for (size_t at = 0; at < whole.size(); at += at < kHeadBytes + 32 ? 1 : 13) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        for (const std::string& bytes : {whole.substr(0, at), damaged}) {
            const auto problems = problems_of(folder, {folder.write("cut", bytes), shard[1]});
            INFO(at << " of " << whole.size() << " bytes");
            REQUIRE(!problems.empty());
            REQUIRE_THAT(problems[0], Catch::Contains("cut: "));
        }
    }
}

TEST_CASE("guided merge: stopping it leaves the earlier output")
{
    const ScratchFolder folder;
    const Paths shard = bake_shards(folder, tiny_scene(), tiny_focus(), 2);
    folder.write("f.lumi", "earlier");
    int calls = 0;
    for (int after = 0; after < 5; ++after) {
        calls = 0;
        CHECK_THROWS_AS(merge_shards(shard, folder.at("f.lumi"), [&] { return calls++ < after; }), Cancelled);
        CHECK(read_bytes(folder.at("f.lumi")) == "earlier");
        CHECK(folder.file_count() == 3);
    }
}

}  // namespace lumi::baker
