// SPDX-License-Identifier: MIT
#include "lumi/baker/chord.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "lumi/chord/field.h"
#include "lumi/chord/texel.h"
#include "support/bake_scenes.h"

namespace lumi::baker
{
namespace
{

using testing::baked;
using testing::read_bytes;
using testing::ScratchFolder;

Scene small_scene()
{
    return testing::ball_over_floor(8, gradient_environment());
}

BakeSettings small_settings(TexelFormat texel)
{
    BakeSettings s = testing::tiny_settings(texel);
    s.origins = 40;
    s.directions = 70;
    s.samples = 4;
    return s;
}

const uint8_t* bytes_of(const std::string& bytes)
{
    return reinterpret_cast<const uint8_t*>(bytes.data());
}

detail::Rgba8 texel_of(const Field& field, uint32_t i, uint32_t j)
{
    const uint8_t* row = field.row(i);
    return detail::with_texel(field.texel_format, [&](auto texel) { return decltype(texel)::load(field, row, j); });
}

}  // namespace

TEST_CASE("bake: core opens and verifies what is written, in every texel format and with a cap")
{
    const Scene scene = small_scene();
    for (const TexelFormat texel : detail::AllTexels::kFormats) {
        for (const uint32_t cap : {0u, 1u, 25u}) {
            BakeSettings settings = small_settings(texel);
            settings.used_origins = cap;
            const std::string bytes = baked(scene, settings);
            INFO("format " << static_cast<int>(texel) << ", cap " << cap);
            CHECK(bytes.size() == field_file_bytes(settings));
            Field field;
            REQUIRE(open_field(bytes_of(bytes), bytes.size(), field) == FieldError::none);
            CHECK(verify_field(bytes_of(bytes), bytes.size()) == FieldError::none);
            CHECK(field.origins.size() == 40);
            CHECK(field.directions.size() == 70);
            CHECK(field.used_origins == (cap ? cap : 40));
            CHECK(field.texel_format == texel);
            float radius = 0;
            std::memcpy(&radius, &field.radius_bits, sizeof radius);
            CHECK(radius == scene.radius());
        }
    }
}

TEST_CASE("bake: the formats agree on coverage and colour")
{
    const Scene scene = small_scene();
    std::string bytes[4];
    Field fields[4];
    for (size_t k = 0; k < 4; ++k) {
        bytes[k] = baked(scene, small_settings(detail::AllTexels::kFormats[k]));
        REQUIRE(open_field(bytes_of(bytes[k]), bytes[k].size(), fields[k]) == FieldError::none);
    }
    uint32_t covered = 0;
    for (uint32_t i = 0; i < 40; ++i) {
        for (uint32_t j = 0; j < 70; ++j) {
            const detail::Rgba8 rgb = texel_of(fields[0], i, j);
            covered += rgb.a ? 1 : 0;
            REQUIRE(texel_of(fields[1], i, j).a == rgb.a);
            REQUIRE(texel_of(fields[3], i, j).a == rgb.a);
            REQUIRE(std::abs(texel_of(fields[1], i, j).g - rgb.g) <= 2);
            const detail::Rgba8 palette = texel_of(fields[2], i, j);
            if (palette.a == 255 && rgb.a == 255) REQUIRE(std::abs(palette.g - rgb.g) < 40);
        }
    }
    CHECK(covered > 500);
    CHECK(covered < 2500);
}

TEST_CASE("bake: the same bytes for any number of threads and every run, others for another seed")
{
    const Scene scene = small_scene();
    for (const TexelFormat texel : {TexelFormat::rgb888, TexelFormat::palette8}) {
        BakeSettings settings = small_settings(texel);
        const std::string one = baked(scene, settings);
        CHECK(baked(small_scene(), settings) == one);
        settings.threads = 2;
        CHECK(baked(scene, settings) == one);
        settings.threads = 3;
        CHECK(baked(scene, settings) == one);
        settings.seed = 2;
        CHECK(baked(scene, settings) != one);
    }
}

TEST_CASE("bake: a texel tells what its ray sees: a ball in constant light is one colour, coverage where it is hit")
{
    testing::SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {0, 0, 0}, 0.5f, 24);
    maker.span_unit_sphere();
    BakeSettings settings = small_settings(TexelFormat::rgb888);
    settings.origins = 4000;  // discs small enough to tell hit from miss
    settings.used_origins = 60;
    settings.directions = 300;
    settings.samples = 64;
    const std::string bytes = baked(maker.make(constant_environment(1)), settings);
    Field field;
    REQUIRE(open_field(bytes_of(bytes), bytes.size(), field) == FieldError::none);
    for (uint32_t i = 0; i < 60; ++i) {
        for (uint32_t j = 0; j < 300; ++j) {
            const Vec3q30 a = detail::point(field.origins, i), b = detail::point(field.directions, j);
            // Distance of the chord from the centre: the half chord is |a - b|/2.
            const double cosine = static_cast<double>(detail::dot_q30(a, b)) / kOneQ30;
            const double distance = std::sqrt((1 + cosine) / 2);
            const double slack = 2 / std::sqrt(4000.0) + 0.01;
            const detail::Rgba8 texel = texel_of(field, i, j);
            if (distance < 0.5 - slack) {
                REQUIRE(texel.a == 255);
                REQUIRE(std::abs(texel.g - 188) <= 6);  // noise of 64 paths
            } else if (distance > 0.5 + slack) {
                REQUIRE(texel.a == 0);
            }
        }
    }
}

TEST_CASE("bake: a cancelled bake leaves the earlier output as it was, and its checkpoint")
{
    const Scene scene = small_scene();
    const ScratchFolder folder;
    const std::filesystem::path out = folder.write("out.lumi", "earlier");
    for (const uint64_t after : {uint64_t{0}, uint64_t{1}}) {
        const ProgressCallback stop = [&](const Progress& p) { return p.rays_done < after; };
        CHECK_THROWS_AS(bake_field(scene, small_settings(TexelFormat::rgb565), out, stop), Cancelled);
        CHECK(read_bytes(out) == "earlier");
        CHECK(folder.file_count() == 2);
    }
    bake_field(scene, small_settings(TexelFormat::rgb565), out);
    CHECK(read_bytes(out).size() == field_file_bytes(small_settings(TexelFormat::rgb565)));
    CHECK(folder.file_count() == 1);
}

TEST_CASE("bake: settings that no field can hold are refused with the mend")
{
    const auto refused = [](const BakeSettings& s, const std::string& what) {
        CHECK_THROWS_WITH(field_file_bytes(s), Catch::Contains(what));
    };
    BakeSettings s;
    s.origins = 0;
    refused(s, "origins must lie in 1 to");
    s = {};
    s.directions = detail::kMaxLatticeSize + 1;
    refused(s, "directions must lie in 1 to");
    s = {};
    s.used_origins = s.origins + 1;
    refused(s, "choose at most all of them");
    s = {};
    s.samples = 0;
    refused(s, "samples must be at least 1");
    s = {};
    s.origins = s.directions = detail::kMaxLatticeSize;
    refused(s, "choose fewer");
}

TEST_CASE("bake: a target that cannot be written is named before the work begins")
{
    const Scene scene = small_scene();
    const ScratchFolder folder;
    int calls = 0;
    const ProgressCallback count = [&](const Progress&) { return ++calls > 0; };
    CHECK_THROWS_WITH(bake_field(scene, small_settings(TexelFormat::luma8), folder.at("no/such/out.lumi"), count),
                      Catch::Contains("cannot be created"));
    CHECK_THROWS_WITH(bake_field(scene, small_settings(TexelFormat::luma8), folder.at(""), count),
                      Catch::Contains("folder"));
    CHECK(calls == 0);
}

TEST_CASE("bake: the smallest lattices work")
{
    const Scene scene = small_scene();
    for (const uint32_t m : {1u, 2u, 3u}) {
        for (const uint32_t n : {1u, 2u, 3u}) {
            BakeSettings settings = small_settings(TexelFormat::palette8);
            settings.origins = m;
            settings.directions = n;
            const std::string bytes = baked(scene, settings);
            Field field;
            REQUIRE(open_field(bytes_of(bytes), bytes.size(), field) == FieldError::none);
            CHECK(verify_field(bytes_of(bytes), bytes.size()) == FieldError::none);
        }
    }
}

}  // namespace lumi::baker
