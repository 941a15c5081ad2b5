// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "fit/fit_model.h"
#include "lumi/baker/merge.h"
#include "store/bake_stages.h"
#include "store/posix_file.h"
#include "surface/surface_file_store.h"
#include "surface/surface_scenes.h"
#include "util/gzip.h"

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

TEST_CASE("a bake of light states goes on in the state where it was stopped, to the same bytes", "[repeated]")
{
    const ScratchFolder folder;
    std::vector<std::string> warnings;
    LoadOptions options;
    options.states = {{"sky"}};
    folder.write("s.mtl", "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl panel\nKd 0 0 0\nKe 1 1 1\n");
    folder.write("s.obj",
                 "mtllib s.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nusemtl grey\n"
                 "f 4 3 2 1\nusemtl panel\nf 1 2 6 5\n");
    options.environment = constant_environment(0.5f);
    const Scene scene = load_scene(folder.at("s.obj"), options, warnings);
    const SurfacePlan plan = planned(scene, tiny_surface());
    const SurfaceBake bake = surface_field(scene, plan);
    const std::string once(bake.file.begin(), bake.file.end());
    for (const double share : {0.1, 0.5, 0.9}) {
        const ScratchFolder work;
        CHECK_THROWS_AS(bake_surface(scene, plan, work.at("f.lumi"), stop_at(share)), Cancelled);
        work.write("f.lumi.state2.part", "of a bake with three states");
        PosixFile used(work.at("f.lumi.state3.part"), PosixFile::Mode::create);
        REQUIRE(used.try_lock());
        CHECK(file_of(scene, plan, work) == once);
        CHECK(work.file_count() == 2);  // the field, and what another bake uses
    }
    CHECK_THROWS_AS(bake_surface_shard(scene, plan, {1, 2}, folder.at("f.1")), BakeError);
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

TEST_CASE("of steps that follow each other the last two are kept, and work goes on behind them")
{
    const ScratchFolder folder;
    std::vector<uint32_t> made;
    const auto sum_of = [&](uint32_t count, uint32_t stop) {
        const auto step = [&](uint32_t k, FitModel& model) {
            if (k == stop) throw Cancelled();
            made.push_back(k);
            model.alike.resize(1000);
            model.alike[0] += static_cast<float>(k + 1);
            return k + 1 < 6;  // the last one is done already
        };
        return BakeStages(folder.at("f.stages"), {1, 2}).in_steps<FitModel>("steps", count, step).alike[0];
    };
    CHECK_THROWS_AS(sum_of(8, 4), Cancelled);
    CHECK(made == std::vector<uint32_t>{0, 1, 2, 3});
    CHECK(read_bytes(folder.at("f.stages")).size() < 3 * 4000);
    made.clear();
    CHECK(sum_of(8, 8) == 1 + 2 + 3 + 4 + 5 + 6);
    CHECK(made == std::vector<uint32_t>{4, 5});
}

TEST_CASE("what is packed comes back, and bytes that are cut or changed are refused")
{
    std::vector<uint8_t> bytes(3000);
    for (size_t k = 0; k < bytes.size(); k += 7) bytes[k] = static_cast<uint8_t>(k * k);
    const std::vector<uint8_t> small = packed(bytes);
    CHECK(small.size() < bytes.size() / 2);
    CHECK(unpacked(small) == bytes);
    CHECK(unpacked(packed({})) == std::vector<uint8_t>{});
    for (size_t size = 0; size < small.size(); ++size)
        CHECK_FALSE(unpacked({small.begin(), small.begin() + static_cast<ptrdiff_t>(size)}));
    for (size_t at = 0; at < small.size(); ++at) {
        std::vector<uint8_t> changed = small;
        changed[at] = static_cast<uint8_t>(changed[at] ^ 0x55);
        CHECK(unpacked(changed).value_or(bytes) == bytes);
    }
}

TEST_CASE("once its result is kept, the pilot's paths leave the disk", "[repeated]")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    CHECK_THROWS_AS(bake_surface(scene, tiny_plan(), folder.at("f.lumi"), stop_at(0.3)), Cancelled);
    CHECK(std::filesystem::file_size(folder.at("f.lumi.part")) > 0);
    CHECK(std::filesystem::file_size(folder.at("f.lumi.stages")) == 0);  // of a plan whose mesh was given
    CHECK(file_of(scene, tiny_plan(), folder) == whole());
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
    SurfaceSettings draft = tiny_surface();
    draft.draft = true;
    const ScratchFolder drafts;
    merge_shards(bake_shards(scene, draft, 2, drafts), drafts.at("f.lumi"));
    CHECK(read_bytes(drafts.at("f.lumi")) == baked(scene, draft));
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
