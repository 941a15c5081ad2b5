// SPDX-License-Identifier: MIT
#include "store/checkpoint.h"

#include <sys/stat.h>
#include <catch2/catch.hpp>

#include "chord/field_writer.h"
#include "image/radiance_picture.h"
#include "lumi/chord/texel.h"
#include "scene/scene_fingerprint.h"
#include "store/bake_stages.h"
#include "support/bake_scenes.h"
#include "support/scratch_folder.h"

namespace lumi::baker
{

using namespace testing;

namespace
{

// The checkpoint of a bake of which the slots below `done` are there.
std::string checkpoint_bytes(const Scene& scene, const BakeSettings& settings, uint32_t done)
{
    const ScratchFolder folder;
    const BakeIdentity identity = identity_of(scene, settings, {});
    bake_shard(scene, settings, {}, folder.at("all"));
    BlockFile all_blocks(std::make_unique<PosixFile>(folder.at("all"), PosixFile::Mode::read));
    const RowFile all(all_blocks);
    Checkpoint checkpoint(folder.at("part"), identity, Earlier::resume);
    RowFile part(checkpoint.blocks());
    checkpoint.reserve(part.complete_bytes(), true);
    Palette palette{};
    REQUIRE(all.read_palette(palette));
    if (settings.texel == TexelFormat::palette8) part.write_palette(palette);
    std::vector<uint8_t> row;
    for (uint32_t slot = 0; slot < done; ++slot) {
        REQUIRE(all.read_row(slot, row));
        part.write_row(slot, row);
    }
    return read_bytes(folder.at("part"));
}

// Bakes on from these bytes; empty if they are refused, and then nothing may have changed.
std::string continued(const Scene& scene, const BakeSettings& settings, const std::string& part)
{
    const ScratchFolder folder;
    folder.write("f.lumi", "earlier");
    folder.write("f.lumi.part", part);
    try {
        bake_field(scene, settings, folder.at("f.lumi"));
    } catch (const BakeError& error) {
        CHECK_THAT(error.what(), Catch::Contains("f.lumi.part: ") && Catch::Contains("; "));
        CHECK(read_bytes(folder.at("f.lumi")) == "earlier");
        CHECK(read_bytes(folder.at("f.lumi.part")) == part);
        CHECK(folder.file_count() == 2);
        return {};
    }
    CHECK(folder.file_count() == 1);
    return read_bytes(folder.at("f.lumi"));
}

}  // namespace

TEST_CASE("checkpoint: a bake goes on from any row and gives the bytes of an undisturbed one, in every texel format",
          "[repeated]")
{
    const Scene scene = tiny_scene();
    for (const TexelFormat texel : detail::AllTexels::kFormats) {
        const BakeSettings settings = tiny_settings(texel);
        const std::string whole = baked(scene, settings);
        for (uint32_t done = 0; done <= settings.origins; ++done) {
            INFO("format " << static_cast<int>(texel) << ", " << done << " rows done");
            REQUIRE(continued(scene, settings, checkpoint_bytes(scene, settings, done)) == whole);
        }
    }
}

TEST_CASE("checkpoint: rows that are done are not traced again", "[repeated]")
{
    const Scene scene = tiny_scene();
    const BakeSettings settings = tiny_settings();
    const ScratchFolder folder;
    folder.write("f.lumi.part", checkpoint_bytes(scene, settings, 4));
    std::vector<Progress> reports;
    bake_field(scene, settings, folder.at("f.lumi"), [&](const Progress& p) {
        reports.push_back(p);
        return true;
    });
    CHECK(reports.front().rays_done == 4 * 11 * 2);
    CHECK(reports.back().rays_done == 9 * 11 * 2);
    CHECK(reports.back().rays_total == 9 * 11 * 2);
}

TEST_CASE("checkpoint: every truncation is survived or refused")
{
    const Scene scene = tiny_scene();
    for (const TexelFormat texel : {TexelFormat::luma8, TexelFormat::palette8}) {
        const BakeSettings settings = tiny_settings(texel);
        const std::string whole = baked(scene, settings);
        const std::string part = checkpoint_bytes(scene, settings, settings.origins);
        // In a palette every length is like the next one.
        const size_t step = texel == TexelFormat::palette8 ? 17 : 1;
        for (size_t size = 0; size < part.size(); size += step) {
            const std::string result = continued(scene, settings, part.substr(0, size));
            INFO("format " << static_cast<int>(texel) << ", " << size << " bytes of " << part.size());
            REQUIRE((size < kHeadBytes ? result.empty() : result == whole));
        }
        REQUIRE(continued(scene, settings, part + "trailing") == whole);
    }
}

TEST_CASE("checkpoint: every damaged byte is mended or refused")
{
    const Scene scene = tiny_scene();
    const BakeSettings settings = tiny_settings(TexelFormat::luma8);
    const std::string whole = baked(scene, settings);
    const std::string part = checkpoint_bytes(scene, settings, settings.origins);
    for (size_t at = 0; at < part.size(); ++at) {
        std::string damaged = part;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
        const std::string result = continued(scene, settings, damaged);
        INFO("byte " << at);
        REQUIRE((at < kHeadBytes ? result.empty() : result == whole));
    }
}

TEST_CASE("checkpoint: a row of another place or another bake is not taken for one's own")
{
    const Scene scene = tiny_scene();
    const BakeSettings settings = tiny_settings(TexelFormat::luma8);
    const std::string part = checkpoint_bytes(scene, settings, settings.origins);
    BakeSettings other = settings;
    other.seed = 77;
    const std::string foreign = checkpoint_bytes(scene, other, settings.origins);
    const std::string whole = baked(scene, settings);
    CHECK(continued(scene, settings, part.substr(0, kHeadBytes) + foreign.substr(kHeadBytes)) == whole);
    const size_t slot = (part.size() - kHeadBytes) / settings.origins;
    std::string swapped = part;
    swapped.replace(kHeadBytes, slot, part, kHeadBytes + slot, slot);
    CHECK(continued(scene, settings, swapped) == whole);
}

TEST_CASE("checkpoint: that of other settings or another scene is refused by name, and discarded on demand")
{
    const Scene scene = tiny_scene();
    const BakeSettings settings = tiny_settings();
    const auto refusal = [&](const Scene& then, const BakeSettings& set_then) {
        const ScratchFolder folder;
        CHECK_THROWS_AS(bake_field(then, set_then, folder.at("f.lumi"), stop_after(1)), Cancelled);
        std::string text;
        try {
            bake_field(scene, settings, folder.at("f.lumi"));
        } catch (const BakeError& error) {
            text = error.what();
        }
        CHECK(folder.file_count() == 1);
        bake_field(scene, settings, folder.at("f.lumi"), {}, Earlier::discard);
        CHECK(read_bytes(folder.at("f.lumi")) == baked(scene, settings));
        CHECK(folder.file_count() == 1);
        return text;
    };
    const auto changed = [&](auto BakeSettings::*member, auto value) {
        BakeSettings other = settings;
        other.*member = value;
        return refusal(scene, other);
    };
    CHECK_THAT(changed(&BakeSettings::samples, 5u), Catch::Contains("other samples: 5 there, 2 here"));
    CHECK_THAT(changed(&BakeSettings::origins, 10u), Catch::Contains("other origins: 10 there, 9 here"));
    CHECK_THAT(changed(&BakeSettings::directions, 12u), Catch::Contains("other directions"));
    CHECK_THAT(changed(&BakeSettings::used_origins, 3u), Catch::Contains("other cap: 3 there, 9 here"));
    CHECK_THAT(changed(&BakeSettings::footprint, Footprint::both),
               Catch::Contains("other footprint: both there, origin here"));
    CHECK_THAT(changed(&BakeSettings::beam, Beam::parallel),
               Catch::Contains("other beam: parallel there, converging here"));
    CHECK_THAT(changed(&BakeSettings::max_error_levels, 0.5f),
               Catch::Contains("other greatest error: 0.5 there, 1 here"));
    CHECK_THAT(changed(&BakeSettings::seed, uint64_t{9}), Catch::Contains("other seed"));
    CHECK_THAT(changed(&BakeSettings::texel, TexelFormat::luma8),
               Catch::Contains("other texels: luma8 there, rgb888 here"));
    CHECK_THAT(refusal(tiny_scene(0.71f), settings), Catch::Contains("another scene") && Catch::Contains("--restart"));
    CHECK_THAT(refusal(tiny_scene(0.7f, 1.01f), settings), Catch::Contains("another scene"));
}

TEST_CASE("checkpoint: anisotropy and sheen enter the identity by every number, however small the change")
{
    const auto fingerprint = [](float Material::*number, const TextureSlot& slot = {}, const Rgb& colour = grey(1)) {
        Material m = testing::metal(grey(0.7f), 0.3f);
        m.anisotropy = m.anisotropy_turns = m.sheen = m.sheen_roughness = 0.5f;
        m.*number = std::nextafter(m.*number, 1.0f);
        m.maps.sheen = slot;
        m.sheen_colour = colour;
        m.finish();
        testing::SceneMaker maker;
        maker.ball(maker.add(m), {}, 0.5f, 4);
        return scene_fingerprint(maker.make(gradient_environment()).data());
    };
    std::vector<Digest::Value> seen;
    for (const auto number : {&Material::alpha, &Material::anisotropy, &Material::anisotropy_turns, &Material::sheen,
                              &Material::sheen_roughness})
        seen.push_back(fingerprint(number));
    CHECK(fingerprint(&Material::alpha) == seen[0]);
    seen.push_back(fingerprint(&Material::alpha, {kNoTexture, {1, 1}, {0.5f, 0}}));
    seen.push_back(fingerprint(&Material::alpha, {kNoTexture, {1, 1}, {}, {0, 1}}));
    seen.push_back(fingerprint(&Material::alpha, {kNoTexture, {1, 1}, {}, {1, 0}, {Wrap::clamp, Wrap::repeat}}));
    seen.push_back(fingerprint(&Material::alpha, {kNoTexture, {1, 1}, {}, {1, 0}, {Wrap::repeat, Wrap::repeat}, true}));
    seen.push_back(fingerprint(&Material::alpha, {}, {1, std::nextafter(1.0f, 0.0f), 1}));
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

TEST_CASE("checkpoint: lights and skies enter the identity by every number, however small the change")
{
    const auto fingerprint = [](const Fixture& fixture, const Environment& sky) {
        testing::SceneMaker maker;
        maker.span_unit_sphere();
        maker.add(fixture);
        return scene_fingerprint(maker.make(sky).data());
    };
    const Environment sky = gradient_environment();
    const SpotLight spot = {{0, 0, 2}, {0, 0, -1}, 0.9f, 0.8f, {3, 2, 1}};
    std::vector<Digest::Value> seen = {fingerprint(spot, sky)};
    CHECK(fingerprint(spot, sky) == seen[0]);
    SpotLight narrower = spot, bluer = spot;
    narrower.cos_inner = std::nextafter(narrower.cos_inner, 1.0f);
    bluer.intensity.b = std::nextafter(bluer.intensity.b, 2.0f);
    seen.push_back(fingerprint(narrower, sky));
    seen.push_back(fingerprint(bluer, sky));
    seen.push_back(fingerprint(PointLight{{0, 0, 2}, {3, 2, 1}}, sky));
    auto picture = std::make_shared<RadiancePicture>(RadiancePicture{2, 1, {grey(1), grey(0.5f)}});
    Environment pictured = sky;
    pictured.picture = picture;
    seen.push_back(fingerprint(spot, pictured));
    pictured.rotation_degrees = 1e-3f;
    seen.push_back(fingerprint(spot, pictured));
    auto brighter = std::make_shared<RadiancePicture>(*picture);
    brighter->pixels[1].g = std::nextafter(0.5f, 1.0f);
    pictured.picture = brighter;
    seen.push_back(fingerprint(spot, pictured));
    std::sort(seen.begin(), seen.end());
    CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
}

TEST_CASE("checkpoint: a cap of all origins, and other threads, are the same bake", "[repeated]")
{
    const Scene scene = tiny_scene();
    BakeSettings settings = tiny_settings();
    const std::string part = checkpoint_bytes(scene, settings, 5);
    const std::string whole = baked(scene, settings);
    settings.used_origins = settings.origins;
    settings.threads = 3;
    CHECK(continued(tiny_scene(), settings, part) == whole);
}

TEST_CASE("checkpoint: of two bakes of one output the second is refused while the first runs")
{
    const Scene scene = tiny_scene();
    const ScratchFolder folder;
    bool tried = false;
    bake_field(scene, tiny_settings(), folder.at("f.lumi"), [&](const Progress&) {
        if (!tried) {
            tried = true;
            CHECK_THROWS_WITH(bake_field(scene, tiny_settings(), folder.at("f.lumi")),
                              Catch::Contains("another lumi is baking this"));
        }
        return true;
    });
    CHECK(tried);
    CHECK(read_bytes(folder.at("f.lumi")) == baked(scene, tiny_settings()));
}

TEST_CASE("checkpoint: a full disk is told by name")
{
    // A device on which every write fails for want of space.
    if (!std::filesystem::exists("/dev/full")) return;
    PosixFile full("/dev/full", PosixFile::Mode::update);
    const uint8_t byte = 1;
    CHECK_THROWS_WITH(full.write_at(0, &byte, 1), Catch::Contains("free some space"));
}

}  // namespace lumi::baker

namespace lumi::baker::testing
{

namespace
{

using Bytes = std::vector<uint8_t>;

const Digest::Value kFirst = {1, 2}, kSecond = {3, 4};
const Bytes kFew = {5, 6, 7}, kMany(5000, 8);

std::string file_of_two(const ScratchFolder& folder)
{
    StageFile file(folder.at("f.stages"));
    file.add(kFirst, kFew);
    file.add(kSecond, kMany);
    return read_bytes(folder.at("f.stages"));
}

bool holds(const ScratchFolder& folder, const Digest::Value& key, const Bytes& expected)
{
    Bytes bytes;
    return StageFile(folder.at("f.stages")).find(key, bytes) && bytes == expected;
}

}  // namespace

TEST_CASE("stage file: what was added is found by its key, by the next process too")
{
    const ScratchFolder folder;
    {
        const StageFile none(folder.at("f.stages"));
        Bytes bytes;
        CHECK_FALSE(none.find(kFirst, bytes));
    }
    CHECK(folder.file_count() == 0);  // nothing is made for nothing
    file_of_two(folder);
    CHECK(holds(folder, kFirst, kFew));
    CHECK(holds(folder, kSecond, kMany));
    Bytes bytes;
    CHECK_FALSE(StageFile(folder.at("f.stages")).find({1, 4}, bytes));
}

TEST_CASE("stage file: of a file that was cut at any length, whole results are found and the others can be added again")
{
    const ScratchFolder folder;
    const std::string whole = file_of_two(folder);
    const size_t first = whole.size() - kMany.size() - 28;
    for (size_t size = 0; size < whole.size(); size += size < first + 40 ? 1 : 331) {
        folder.write("f.stages", whole.substr(0, size));
        INFO(size);
        CHECK(holds(folder, kFirst, kFew) == (size >= first));
        CHECK_FALSE(holds(folder, kSecond, kMany));
        StageFile(folder.at("f.stages")).add(kSecond, kMany);
        CHECK(holds(folder, kSecond, kMany));
    }
}

TEST_CASE("stage file: a damaged byte loses its result, and never gives a wrong one")
{
    const ScratchFolder folder;
    const std::string whole = file_of_two(folder);
    const size_t first = whole.size() - kMany.size() - 28;
    for (size_t at = 0; at < whole.size(); at += at < first + 40 ? 1 : 331) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x80);
        folder.write("f.stages", damaged);
        INFO(at);
        const StageFile file(folder.at("f.stages"));
        Bytes bytes;
        CHECK((at >= first || !file.find(kFirst, bytes)));
        CHECK((at < first || !file.find(kSecond, bytes)));
        if (at >= first) {
            REQUIRE(file.find(kFirst, bytes));
            CHECK((bytes == kFew));
        }
    }
}

TEST_CASE("stage file: where it cannot be written or another process has it, nothing is kept and nothing fails")
{
    const ScratchFolder folder;
    Bytes bytes;
    StageFile nowhere(folder.at("none/f.stages"));
    nowhere.add(kFirst, kFew);
    CHECK_FALSE(nowhere.find(kFirst, bytes));
    StageFile unnamed{std::filesystem::path()};
    unnamed.add(kFirst, kFew);
    CHECK_FALSE(unnamed.find(kFirst, bytes));
    std::filesystem::create_directories(folder.at("d.stages"));
    StageFile at_folder(folder.at("d.stages"));
    at_folder.add(kFirst, kFew);
    CHECK(std::filesystem::is_directory(folder.at("d.stages")));

    StageFile owner(folder.at("f.stages"));
    owner.add(kFirst, kFew);
    StageFile second(folder.at("f.stages"));  // the lock is held
    CHECK_FALSE(second.find(kFirst, bytes));
    second.add(kSecond, kMany);
    CHECK(owner.find(kFirst, bytes));
    CHECK_FALSE(owner.find(kSecond, bytes));
}

}  // namespace lumi::baker::testing
