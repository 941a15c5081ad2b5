// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <random>

#include "guided/chart_file.h"
#include "guided/guided_scenes.h"
#include "store/block_file.h"

namespace lumi::baker
{

using namespace testing;
using format::TexelFormat;

namespace
{

// What came of a bake that found a checkpoint.
struct Continued {
    std::string field;  // empty: refused
    std::string refusal;
    Progress first;  // report that knows the number of rays
};

Continued go_on(const Scene& scene, const GuidedSettings& settings, const std::string& part)
{
    const ScratchFolder folder;
    folder.write("f.lumi", "earlier");
    folder.write("f.lumi.part", part);
    Continued result;
    const ProgressCallback note = [&](const Progress& p) {
        if (result.first.rays_total <= 1) {
            result.first = p;
        }
        return true;
    };
    try {
        bake_guided(scene, settings, folder.at("f.lumi"), note);
    } catch (const BakeError& error) {
        result.refusal = error.what();
        CHECK_THAT(result.refusal, Catch::Contains("f.lumi.part: ") && Catch::Contains("; "));
        CHECK(read_bytes(folder.at("f.lumi")) == "earlier");
        CHECK(read_bytes(folder.at("f.lumi.part")) == part);
        CHECK(folder.file_count() == 2);
        return result;
    }
    CHECK(folder.file_count() == 1);
    result.field = read_bytes(folder.at("f.lumi"));
    return result;
}

// Of a bake that was stopped when all was traced.
std::string complete_checkpoint(const Scene& scene, const GuidedSettings& settings)
{
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_guided(scene, settings, folder.at("f.lumi"),
                                [](const Progress& p) { return p.rays_done != p.rays_total; }),
                    Cancelled);
    CHECK(folder.file_count() == 1);
    return read_bytes(folder.at("f.lumi.part"));
}

// That of a bake which has traced `charts` of its charts and, of the rest, the points or not.
std::string partial_checkpoint(const std::string& complete, uint32_t charts, bool has_points)
{
    const ScratchFolder folder;
    BlockFile blocks(std::make_unique<PosixFile>(folder.write("part", complete), PosixFile::Mode::read));
    ChartFile file(blocks);
    REQUIRE(file.read_sizes());
    std::string part = complete;
    uint64_t begin = file.shard_bytes();
    for (uint32_t slot = file.slot_count(); slot-- > charts;) {
        const std::optional<TracedChart> chart = file.read_chart(slot);
        REQUIRE(chart);
        begin -= kSealBytes + encode(*chart).size();
    }
    const uint64_t end = has_points ? file.shard_bytes() : complete.size();
    std::fill(part.begin() + static_cast<std::ptrdiff_t>(begin), part.begin() + static_cast<std::ptrdiff_t>(end), '\0');
    return part;
}

}  // namespace

TEST_CASE("guided checkpoint: a bake goes on from any chart and gives the bytes of an undisturbed one, of every kind",
          "[repeated]")
{
    const Scene scene = tiny_scene();
    for (const GuidedSettings& settings : tiny_guided_of_every_kind()) {
        const std::string whole = baked(scene, settings);
        const std::string complete = complete_checkpoint(scene, settings);
        const bool has_charts = settings.texel != format::GuidedTexel::none;
        const uint32_t all = !has_charts ? 0 : settings.used_origins != 0 ? settings.used_origins : settings.origins;
        uint64_t least_done = 0;
        for (const uint32_t done : {0u, 1u, all / 2, all - 1, all}) {
            for (const bool has_points : {false, true}) {
                if (done > all) {
                    continue;
                }
                const Continued result = go_on(scene, settings, partial_checkpoint(complete, done, has_points));
                INFO(done << " charts done of " << all << ", points " << has_points);
                REQUIRE(result.field == whole);
                if (done == all && has_points) {
                    CHECK(result.first.rays_done == result.first.rays_total);
                }
                if (has_points) {
                    CHECK(result.first.rays_done >= least_done);
                    least_done = result.first.rays_done;
                }
            }
        }
    }
}

TEST_CASE("guided checkpoint: charts and points that are done are not traced again", "[repeated]")
{
    const Scene scene = tiny_scene();
    const GuidedSettings settings = tiny_focus();
    const std::string complete = complete_checkpoint(scene, settings);
    const Continued none = go_on(scene, settings, partial_checkpoint(complete, 0, true));
    const Continued three = go_on(scene, settings, partial_checkpoint(complete, 3, true));
    CHECK(none.first.rays_done == 0);
    CHECK(three.first.rays_done > none.first.rays_total / 2);
    CHECK(three.first.rays_done < none.first.rays_total);
    CHECK(three.first.rays_total == none.first.rays_total);
}

TEST_CASE("guided checkpoint: a bake stopped again and again is bit-identical to an undisturbed one", "[repeated]")
{
    const Scene scene = tiny_scene();
    for (GuidedSettings settings : tiny_guided_of_every_kind()) {
        const std::string whole = baked(scene, settings);
        const ScratchFolder folder;
        std::mt19937 random(7);
        bool done = false;
        for (int stops = 0; !done; ++stops) {
            REQUIRE(stops < 1000);
            settings.threads = 1 + static_cast<unsigned>(stops % 3);
            int calls_left = std::uniform_int_distribution<int>(0, 4)(random) + stops / 8;
            try {
                bake_guided(scene, settings, folder.at("f.lumi"), [&](const Progress&) { return calls_left-- > 0; });
                done = true;
            } catch (const Cancelled&) {
                CHECK(folder.file_count() == 1);
            }
        }
        CHECK(read_bytes(folder.at("f.lumi")) == whole);
        CHECK(folder.file_count() == 1);
    }
}

TEST_CASE("guided checkpoint: a chart that was cut off in the middle is not kept", "[repeated]")
{
    const Scene scene = tiny_scene();
    GuidedSettings settings = tiny_focus();
    settings.used_origins = 2;
    settings.chart_size = 24;
    settings.samples = 600;  // a chart takes longer than it takes to be told to stop
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_guided(scene, settings, folder.at("f.lumi"), stop_after(1)), Cancelled);
    bake_guided(scene, settings, folder.at("f.lumi"));
    CHECK(read_bytes(folder.at("f.lumi")) == baked(scene, settings));
}

TEST_CASE("guided checkpoint: every truncation is survived or refused")
{
    const Scene scene = tiny_scene();
    struct Case {
        GuidedSettings settings;
        size_t step;  // lengths left out between those tried
    };
    // Each bake with a mean builds its proxy: some lengths then stand for their neighbours.
    for (const Case& c : {Case{tiny_focus(), 31}, Case{tiny_guided(), 8191}}) {
        const std::string whole = baked(scene, c.settings);
        const std::string part = complete_checkpoint(scene, c.settings);
        for (size_t size = 0; size < part.size(); size += size <= kHeadBytes ? 1 : c.step) {
            INFO(size << " bytes of " << part.size());
            const Continued result = go_on(scene, c.settings, part.substr(0, size));
            REQUIRE((size < kHeadBytes ? result.field.empty() : result.field == whole));
        }
        REQUIRE(go_on(scene, c.settings, part + "trailing").field == whole);
    }
}

TEST_CASE("guided checkpoint: every damaged byte is mended or refused")
{
    const Scene scene = tiny_scene();
    const GuidedSettings settings = tiny_focus();
    const std::string whole = baked(scene, settings);
    const std::string part = complete_checkpoint(scene, settings);
    for (size_t at = 0; at < part.size(); at += at < kHeadBytes + 32 ? 1 : 29) {
        std::string damaged = part;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
        INFO("byte " << at);
        const Continued result = go_on(scene, settings, damaged);
        REQUIRE((at < kHeadBytes ? result.field.empty() : result.field == whole));
    }
}

TEST_CASE("guided checkpoint: charts of another bake are not taken for one's own")
{
    const Scene scene = tiny_scene();
    GuidedSettings other = tiny_focus();
    other.seed = 77;
    const std::string part = complete_checkpoint(scene, tiny_focus()), foreign = complete_checkpoint(scene, other);
    REQUIRE(part.size() == foreign.size());
    CHECK(go_on(scene, tiny_focus(), part.substr(0, kHeadBytes) + foreign.substr(kHeadBytes)).field ==
          baked(scene, tiny_focus()));
}

TEST_CASE("guided checkpoint: that of other settings, another layout or another scene is refused by name")
{
    const Scene scene = tiny_scene();
    const GuidedSettings settings = tiny_guided();
    const auto refusal = [&](const GuidedSettings& then) {
        const ScratchFolder folder;
        CHECK_THROWS_AS(bake_guided(scene, then, folder.at("f.lumi"), stop_after(0)), Cancelled);
        return go_on(scene, settings, read_bytes(folder.at("f.lumi.part"))).refusal;
    };
    const auto changed = [&](auto GuidedSettings::*member, auto value) {
        GuidedSettings other = settings;
        other.*member = value;
        return refusal(other);
    };
    using Catch::Contains;
    CHECK_THAT(changed(&GuidedSettings::origins, 65u),
               Contains("other origins: 65 there, 64 here") && Contains("--restart"));
    CHECK_THAT(changed(&GuidedSettings::used_origins, 8u), Contains("other cap: 8 there, 64 here"));
    CHECK_THAT(changed(&GuidedSettings::chart_size, 11u), Contains("other chart: 11 there, 10 here"));
    CHECK_THAT(changed(&GuidedSettings::texel, format::GuidedTexel::index8),
               Contains("other texels: 8 bits there, 4 bits here"));
    CHECK_THAT(changed(&GuidedSettings::proxy_triangles, 41u), Contains("other proxy triangles: 41 there, 40 here"));
    CHECK_THAT(changed(&GuidedSettings::mean_resolution, 9u), Contains("other mean resolution: 9 there, 8 here"));
    CHECK_THAT(changed(&GuidedSettings::mean_format, format::MeanFormat::rgb565),
               Contains("other mean format: rgb565 there, palette8 here"));
    CHECK_THAT(changed(&GuidedSettings::occlusion, false), Contains("other occlusion: without there, with here"));
    CHECK_THAT(changed(&GuidedSettings::samples, 3u), Contains("other samples: 3 there, 2 here"));
    CHECK_THAT(changed(&GuidedSettings::jitter, 0.5f), Contains("other jitter: 0.5 there, 0.6 here"));
    CHECK_THAT(changed(&GuidedSettings::seed, uint64_t{9}), Contains("other seed: 9 there, 1 here"));
    CHECK_THAT(refusal(tiny_focus()), Contains("other layout: focus there, guided here"));
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_field(scene, tiny_settings(), folder.at("f.lumi"), stop_after(0)), Cancelled);
    CHECK_THAT(go_on(scene, settings, read_bytes(folder.at("f.lumi.part"))).refusal,
               Contains("other layout: chord there, guided here"));
    CHECK_THROWS_WITH(bake_field(scene, tiny_settings(TexelFormat::luma8), folder.at("f.lumi")),
                      Contains("other texels: rgb888 there"));
    CHECK_THAT(go_on(tiny_scene(0.71f), settings, complete_checkpoint(scene, settings)).refusal,
               Contains("another scene"));
}

TEST_CASE("guided checkpoint: focus points and radii enter the identity; one that is refused can be discarded")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    GuidedSettings other = tiny_focus();
    other.focus = {0.1f, 0, 0};
    CHECK_THROWS_AS(bake_guided(scene, other, folder.at("f.lumi"), stop_after(0)), Cancelled);
    CHECK_THROWS_WITH(bake_guided(scene, tiny_focus(), folder.at("f.lumi")),
                      Catch::Contains("other focus: 0.1,0,0 there, the centre here"));
    GuidedSettings wider = other;
    wider.focus_radius = 0.6f;
    CHECK_THROWS_WITH(bake_guided(scene, wider, folder.at("f.lumi")),
                      Catch::Contains("other focus radius: 0.5 there, 0.6 here"));
    bake_guided(scene, tiny_focus(), folder.at("f.lumi"), {}, Earlier::discard);
    CHECK(read_bytes(folder.at("f.lumi")) == baked(scene, tiny_focus()));
    CHECK(folder.file_count() == 1);
}

TEST_CASE("guided checkpoint: of two bakes of one output the second is refused while the first runs")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    bool tried = false;
    bake_guided(scene, tiny_focus(), folder.at("f.lumi"), [&](const Progress&) {
        if (!tried) {
            tried = true;
            CHECK_THROWS_WITH(bake_guided(scene, tiny_focus(), folder.at("f.lumi")),
                              Catch::Contains("another lumi is baking this"));
        }
        return true;
    });
    CHECK(tried);
    CHECK(read_bytes(folder.at("f.lumi")) == baked(scene, tiny_focus()));
}

TEST_CASE("guided checkpoint: a field that no file can hold is refused before the work")
{
    const ScratchFolder folder;
    GuidedSettings settings = tiny_focus();
    settings.chart_size = format::kMaxChart;
    settings.samples = 1'000'000;
    CHECK_THROWS_WITH(bake_guided(tiny_scene(), settings, folder.at("f.lumi")),
                      Catch::Contains("choose a smaller --chart"));
}

}  // namespace lumi::baker
