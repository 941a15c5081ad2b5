// SPDX-License-Identifier: MIT
#include "lumi/baker/merge.h"

#include <catch2/catch.hpp>
#include <set>

#include "chord/field_writer.h"
#include "lumi/chord/texel.h"
#include "lumi/detail/crc32.h"
#include "store/shard_set.h"
#include "support/bake_scenes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{

using namespace testing;

namespace
{

using Paths = std::vector<std::filesystem::path>;

// The problems that merging names; the output must then be as before.
std::vector<std::string> problems_of(const ScratchFolder& folder, const Paths& shards)
{
    folder.write("f.lumi", "earlier");
    try {
        merge_shards(shards, folder.at("f.lumi"));
    } catch (const MergeError& error) {
        CHECK(read_bytes(folder.at("f.lumi")) == "earlier");
        return error.problems;
    }
    return {};
}

constexpr uint32_t kCount = 3;

std::string name_of(uint32_t k)
{
    return std::to_string(k) + ".shard";
}

void bake_rows(const ScratchFolder& folder, const Scene& scene, const BakeSettings& settings, uint32_t count = kCount)
{
    for (uint32_t k = 1; k <= count; ++k) bake_shard(scene, settings, {k, count}, folder.at(name_of(k)));
}

// A shard as an older lumi would have written it.
std::string made_by(std::string shard, const std::string& version)
{
    constexpr size_t kProgramAt = 12;
    shard.replace(kProgramAt, version.size(), version);
    const size_t crc_at = kHeadBytes - 4;
    const uint32_t crc = detail::crc32(0, reinterpret_cast<const uint8_t*>(shard.data()), crc_at);
    for (size_t k = 0; k < 4; ++k) shard[crc_at + k] = static_cast<char>(crc >> (8 * k) & 0xFF);
    return shard;
}

}  // namespace

TEST_CASE("shards: each row belongs to one, and all are of equal size to one row")
{
    for (const uint32_t rows : {1u, 2u, 7u, 89u, 1000u}) {
        for (const uint32_t count : {1u, 2u, 3u, 8u, 13u, 89u, 200u}) {
            std::set<uint32_t> seen;
            for (uint32_t k = 1; k <= count; ++k) {
                const ShardRows shard(rows, {k, count});
                INFO(rows << " rows, shard " << k << " of " << count);
                CHECK(shard.size() >= rows / count);
                CHECK(shard.size() <= rows / count + 1);
                for (uint32_t slot = 0; slot < shard.size(); ++slot) {
                    const uint32_t row = shard.row(slot);
                    REQUIRE(row < rows);
                    REQUIRE(seen.insert(row).second);
                    REQUIRE(ShardRows::index_of(row, count) == k);
                    REQUIRE(ShardRows::slot_of(row, count) == slot);
                }
            }
            CHECK(seen.size() == rows);
        }
    }
}

TEST_CASE("shards: a shard looks from all around, also where their number is one of Fibonacci's")
{
    constexpr uint32_t kRows = 2048;
    for (const uint32_t count : {8u, 13u, 16u, 34u, 55u}) {
        for (const uint32_t k : {1u, count / 2, count}) {
            const ShardRows shard(kRows, {k, count});
            double x = 0, y = 0;
            for (uint32_t slot = 0; slot < shard.size(); ++slot) {
                const double turns = std::fmod(shard.row(slot) * 0.6180339887498949, 1.0);
                x += std::cos(2 * 3.14159265358979 * turns) / shard.size();
                y += std::sin(2 * 3.14159265358979 * turns) / shard.size();
            }
            // The mean of n random directions is about 1/√n long.
            INFO("shard " << k << " of " << count);
            CHECK(std::hypot(x, y) < 3 / std::sqrt(static_cast<double>(shard.size())));
        }
    }
}

TEST_CASE("merge: the field is that of one machine, bit for bit, in every texel format, in any order", "[repeated]")
{
    const Scene scene = tiny_scene();
    for (const TexelFormat texel : detail::AllTexels::kFormats) {
        for (const uint32_t count : {1u, 2u, 5u, 9u, 11u}) {  // with 11, two hold no row
            const ScratchFolder folder;
            bake_rows(folder, scene, tiny_settings(texel), count);
            Paths shards;
            for (uint32_t k = count; k >= 1; --k) shards.push_back(folder.at(name_of(k)));
            const MergedField merged = merge_shards(shards, folder.at("f.lumi"));
            INFO("format " << static_cast<int>(texel) << ", " << count << " shards");
            CHECK(read_bytes(folder.at("f.lumi")) == baked(scene, tiny_settings(texel)));
            CHECK(merged.bytes == read_bytes(folder.at("f.lumi")).size());
            CHECK(folder.file_count() == count + 1);
        }
    }
}

TEST_CASE("shard: one that was stopped goes on, and gives the same bytes", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    bake_shard(scene, tiny_settings(), {2, 3}, folder.at("whole"));
    CHECK_THROWS_AS(bake_shard(scene, tiny_settings(), {2, 3}, folder.at("s"), stop_after(1)), Cancelled);
    CHECK(!std::filesystem::exists(folder.at("s")));
    CHECK_THROWS_WITH(bake_shard(scene, tiny_settings(), {1, 3}, folder.at("s")), Catch::Contains("another shard"));
    bake_shard(scene, tiny_settings(), {2, 3}, folder.at("s"));
    CHECK(read_bytes(folder.at("s")) == read_bytes(folder.at("whole")));
    CHECK(folder.file_count() == 2);
}

TEST_CASE("shard: a complete one is left alone, of a damaged one the damaged row is baked again", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    bake_shard(scene, tiny_settings(), {1, 2}, folder.at("s"));
    const std::string whole = read_bytes(folder.at("s"));
    uint64_t first = 0;
    int calls = 0;
    const ProgressCallback note = [&](const Progress& p) {
        first = calls++ == 0 ? p.rays_done : first;
        return true;
    };
    bake_shard(scene, tiny_settings(), {1, 2}, folder.at("s"), note);
    CHECK(calls == 0);
    std::string damaged = whole;
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    folder.write("s", damaged);
    bake_shard(scene, tiny_settings(), {1, 2}, folder.at("s"), note);
    const uint32_t rows = shard_rows(tiny_settings(), {1, 2});
    CHECK(first == (rows - 1) * 11 * 2);
    CHECK(read_bytes(folder.at("s")) == whole);
    bake_shard(scene, tiny_settings(), {2, 2}, folder.at("s"));  // another bake's file is replaced, as any output
    CHECK(read_bytes(folder.at("s")) != whole);
}

TEST_CASE("merge: missing, double, foreign, stale, damaged and unfinished shards are each named")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    bake_rows(folder, scene, tiny_settings());
    const auto shard = [&](uint32_t k) { return folder.at(name_of(k)); };

    auto problems = problems_of(folder, {shard(2)});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Contains("shards 1, 3 of 3 are missing"));
    problems = problems_of(folder, {shard(1), shard(2)});
    REQUIRE(problems.size() == 1);
    CHECK(problems[0] == "shard 3 of 3 is missing; bake it with --shard 3/3");

    folder.write("copy", read_bytes(shard(2)));
    problems = problems_of(folder, {shard(1), shard(2), folder.at("copy"), shard(3)});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Contains("copy: is shard 2, as ") && Catch::Contains("leave one of them out"));

    BakeSettings other = tiny_settings();
    other.samples = 3;
    bake_shard(scene, other, {3, 3}, folder.at("foreign"));
    problems = problems_of(folder, {shard(1), shard(2), folder.at("foreign")});
    REQUIRE(problems.size() == 2);
    CHECK_THAT(problems[0], Catch::Contains("foreign: belongs to another bake") &&
                                Catch::Contains("other samples: 3 there, 2 here"));
    CHECK_THAT(problems[1], Catch::Contains("shard 3 of 3 is missing"));
    bake_shard(tiny_scene(0.5f), tiny_settings(), {3, 3}, folder.at("scene"));
    problems = problems_of(folder, {folder.at("scene"), shard(1), shard(2), shard(3)});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Contains("scene: belongs to another bake") && Catch::Contains("another scene"));
    bake_shard(scene, tiny_settings(), {2, 4}, folder.at("fourth"));
    problems = problems_of(folder, {shard(1), shard(2), shard(3), folder.at("fourth")});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Contains("other number of shards: 4 there, 3 here"));

    folder.write("old", made_by(read_bytes(shard(3)), "0.0.9"));
    problems = problems_of(folder, {shard(1), shard(2), folder.at("old")});
    REQUIRE(problems.size() == 2);
    CHECK_THAT(problems[0], Catch::Contains("old: is stale") && Catch::Contains("0.0.9 there"));

    std::string damaged = read_bytes(shard(1));
    damaged[damaged.size() - 3] = static_cast<char>(damaged[damaged.size() - 3] ^ 4);
    folder.write("damaged", damaged);
    problems = problems_of(folder, {folder.at("damaged"), shard(2), shard(3)});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Contains("damaged: 1 of 3 rows are missing or damaged, first that of origin "));

    CHECK_THROWS_AS(bake_shard(scene, tiny_settings(), {1, 3}, folder.at("u"), stop_after(0)), Cancelled);
    problems = problems_of(folder, {folder.at("u.part"), shard(2), shard(3)});
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], Catch::Contains("u.part: "));

    problems = problems_of(folder, {folder.at("none"), folder.write("text", "hello"), shard(1), shard(2), shard(3)});
    REQUIRE(problems.size() == 2);
    CHECK_THAT(problems[0], Catch::Contains("none: cannot be opened"));
    CHECK_THAT(problems[1], Catch::Contains("text: is no file of baked rows"));
    CHECK(problems_of(folder, {}).size() == 1);
    CHECK_THROWS_WITH(merge_shards({shard(1), shard(2), shard(3)}, shard(2)), Catch::Contains("reads this file"));
}

TEST_CASE("merge: of a million missing shards a few are named")
{
    const ScratchFolder folder;
    bake_shard(tiny_scene(), tiny_settings(), {2, 1000000}, folder.at("s"));
    const auto problems = problems_of(folder, {folder.at("s")});
    REQUIRE(problems.size() == 1);
    CHECK(
        problems[0] ==
        "shards 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21 and 999979 more of 1000000 are "
        "missing; bake each with --shard K/1000000");
}

TEST_CASE("merge: rows beyond the end of a file are missing, and none of them is looked for")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    for (const TexelFormat texel : {TexelFormat::rgb888, TexelFormat::palette8}) {
        bake_shard(scene, tiny_settings(texel), {1, 1}, folder.at("s"));
        const std::string whole = read_bytes(folder.at("s"));
        uint32_t before = 0;
        for (size_t size = kHeadBytes; size <= whole.size(); ++size) {
            folder.write("cut", whole.substr(0, size));
            BlockFile file(std::make_unique<PosixFile>(folder.at("cut"), PosixFile::Mode::read));
            const RowFile rows(file);
            const uint32_t within = rows.slots_within_file();
            INFO(size << " bytes of " << whole.size());
            REQUIRE((within == before || within == before + 1));
            REQUIRE(missing_slots(rows).size() == rows.slot_count() - within);
            before = within;
            if (size == whole.size()) CHECK(within == rows.slot_count());
        }
    }
}

TEST_CASE("merge: every truncation of a shard is refused by name")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    bake_rows(folder, scene, tiny_settings(TexelFormat::luma8), 2);
    const std::string whole = read_bytes(folder.at(name_of(1)));
    for (size_t size = 0; size < whole.size(); ++size) {
        folder.write("cut", whole.substr(0, size));
        const auto problems = problems_of(folder, {folder.at("cut"), folder.at(name_of(2))});
        INFO(size << " bytes of " << whole.size());
        REQUIRE(!problems.empty());
        REQUIRE_THAT(problems[0], Catch::Contains("cut: "));
    }
}

TEST_CASE("merge: stopping it leaves the earlier output")
{
    const ScratchFolder folder;
    bake_rows(folder, tiny_scene(), tiny_settings());
    folder.write("f.lumi", "earlier");
    for (int after = 0; after < 12; ++after) {
        int calls = 0;
        CHECK_THROWS_AS(merge_shards({folder.at(name_of(1)), folder.at(name_of(2)), folder.at(name_of(3))},
                                     folder.at("f.lumi"), [&] { return calls++ < after; }),
                        Cancelled);
        CHECK(read_bytes(folder.at("f.lumi")) == "earlier");
        CHECK(folder.file_count() == kCount + 1);
    }
}

}  // namespace lumi::baker
