// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "fit/fit_model.h"
#include "lumi/baker/merge.h"
#include "store/bake_stages.h"
#include "surface/surface_file_store.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

// A bake of the tiny scene that was never stopped.
const std::string& whole()
{
    static const std::string bytes = baked(tiny_scene(), tiny_surface());
    return bytes;
}

// For bakes of the tiny scene that are not about its mesh, which is made once.
SurfacePlan tiny_plan(const SurfaceSettings& settings = tiny_surface())
{
    static const SurfacePlan made = planned(tiny_scene(), tiny_surface());
    SurfacePlan plan = made;
    plan.settings = settings;
    return plan;
}

std::string file_of(const Scene& scene, const SurfacePlan& plan, const ScratchFolder& folder)
{
    bake_surface(scene, plan, folder.at("f.lumi"));
    return read_bytes(folder.at("f.lumi"));
}

// Cancels once so many of a bake's light paths are traced; reports of the mesh are let pass.
ProgressCallback stop_at(double share)
{
    return [share](const Progress& p) {
        return p.stage == Stage::mesh || static_cast<double>(p.rays_done) < share * static_cast<double>(p.rays_total);
    };
}

std::vector<std::filesystem::path> bake_shards(const Scene& scene, const SurfaceSettings& settings, uint32_t count,
                                               const ScratchFolder& folder)
{
    std::vector<std::filesystem::path> files;
    for (uint32_t k = 1; k <= count; ++k) {
        files.push_back(folder.at("f." + std::to_string(k)));
        bake_surface_shard(scene, tiny_plan(settings), {k, count}, files.back());
    }
    return files;
}

}  // namespace

TEST_CASE("a surface bake goes on where it was stopped, to the same bytes", "[repeated]")
{
    const Scene scene = tiny_scene();
    for (const double share : {0.1, 0.95}) {
        const ScratchFolder folder;
        CHECK_THROWS_AS(bake_surface(scene, {tiny_surface()}, folder.at("f.lumi"), stop_at(share)), Cancelled);
        CHECK(folder.file_count() == 2);  // checkpoint and stages
        CHECK(file_of(scene, {tiny_surface()}, folder) == whole());
        CHECK(folder.file_count() == 1);
    }
}

TEST_CASE("what a stopped surface bake has traced is not traced again", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_surface(scene, tiny_plan(), folder.at("f.lumi"), stop_at(1)), Cancelled);
    std::optional<uint64_t> first;
    bool traces = false;
    bake_surface(scene, tiny_plan(), folder.at("f.lumi"), [&](const Progress& p) {
        first = first ? first : p.rays_done;
        traces = traces || (p.stage == Stage::light && p.rays_done != *first && p.rays_done < p.rays_total);
        return true;
    });
    CHECK_FALSE(traces);
    CHECK(first > 0u);
}

TEST_CASE("a stage is done once for a scene, a name and settings, and what it gave is found")
{
    const ScratchFolder folder;
    FitModel model;
    model.texels = {{1, 2, 3}, {4.5f, -5, 6}};
    model.nodes = {{7, 8, 9}};
    int made = 0;
    const auto got = [&](const Digest::Value& scene, const char* name, uint32_t setting) {
        const auto make = [&] {
            ++made;
            return model;
        };
        const auto result = BakeStages(folder.at("f.stages"), scene).once<FitModel>(name, make, setting);
        CHECK((result.texels == model.texels && result.nodes == model.nodes));
    };
    for (int twice = 0; twice < 2; ++twice) {
        got({1, 2}, "a", 3);
        got({1, 2}, "a", 4);
        got({1, 2}, "b", 3);
        got({1, 3}, "a", 3);
    }
    CHECK(made == 4);
}

TEST_CASE("a file of stages that holds another mesh or another pilot is not used", "[repeated]")
{
    const Scene scene = tiny_scene(), other = tiny_scene(0.2f);
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_surface(other, {tiny_surface()}, folder.at("f.lumi"), stop_at(0.1)), Cancelled);
    std::filesystem::remove(folder.at("f.lumi.part"));
    SurfaceSettings seed = tiny_surface();
    seed.seed = 7;
    CHECK_THROWS_AS(bake_surface(scene, {seed}, folder.at("f.lumi"), stop_at(0.1)), Cancelled);
    std::filesystem::remove(folder.at("f.lumi.part"));
    CHECK(file_of(scene, {tiny_surface()}, folder) == whole());
}

TEST_CASE("a damaged surface checkpoint is traced again, to the same bytes", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_surface(scene, tiny_plan(), folder.at("f.lumi"), stop_at(1)), Cancelled);
    const std::string part = read_bytes(folder.at("f.lumi.part"));
    for (const size_t at : {part.size() - 1, size_t{230}}) {
        std::string damaged = part;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        folder.write("f.lumi.part", damaged);
        CHECK(file_of(scene, tiny_plan(), folder) == whole());
    }
}

TEST_CASE("a checkpoint of other surface settings is refused by name")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_surface(scene, tiny_plan(), folder.at("f.lumi"), stop_at(0.1)), Cancelled);
    SurfaceSettings other = tiny_surface();
    other.texels_per_radius = 7;
    CHECK_THROWS_WITH(bake_surface(scene, {other}, folder.at("f.lumi")),
                      Catch::Contains("other texel density: 6 there, 7 here"));
}

TEST_CASE("shards of a surface bake merge to the bytes of the whole", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    std::vector<std::filesystem::path> shards = bake_shards(scene, tiny_surface(), 3, folder);
    std::reverse(shards.begin(), shards.end());
    const MergedField merged = merge_shards(shards, folder.at("f.lumi"));
    CHECK(merged.shards == 3);
    CHECK(read_bytes(folder.at("f.lumi")) == whole());
}

TEST_CASE("missing and damaged and foreign and unfinished surface shards are named", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    SurfaceSettings settings = tiny_surface();
    settings.paths_per_texel = 100;
    const std::vector<std::filesystem::path> shards = bake_shards(scene, settings, 2, folder);
    CHECK_THROWS_WITH(merge_shards({shards[1]}, folder.at("f.lumi")), Catch::Contains("shard 1 of 2 is missing"));
    std::string bytes = read_bytes(shards[0]);
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    folder.write("f.1", bytes);
    CHECK_THROWS_WITH(merge_shards(shards, folder.at("f.lumi")), Catch::Contains("f.1: is not finished or damaged"));
    CHECK_THROWS_AS(bake_surface_shard(scene, tiny_plan(settings), {1, 2}, folder.at("u"), stop_at(0.4)), Cancelled);
    CHECK_THROWS_WITH(merge_shards({folder.at("u.part"), shards[1]}, folder.at("f.lumi")),
                      Catch::Contains("u.part: is not finished or damaged"));
    SurfaceSettings other = settings;
    other.seed = 2;
    bake_surface_shard(scene, tiny_plan(other), {1, 2}, folder.at("f.1"), {}, Earlier::discard);
    CHECK_THROWS_WITH(merge_shards(shards, folder.at("f.lumi")), Catch::Contains("other seed"));
}

}  // namespace lumi::baker::testing

namespace lumi::baker
{

TEST_CASE("fit basis: shards keep every tone curve, and one that is none is refused")
{
    FitBasis basis = {};
    for (int curve = 0; curve <= static_cast<int>(kLastToneCurve) + 1; ++curve) {
        basis.tone = static_cast<ToneCurve>(curve);
        const std::optional<FitBasis> read = decode_basis(encode(basis));
        REQUIRE(read.has_value() == (basis.tone <= kLastToneCurve));
        if (read) CHECK(read->tone == basis.tone);
    }
}

}  // namespace lumi::baker
