// SPDX-License-Identifier: MIT
// The chord field and the sprites that fields are compared with.
#include "comparison/baselines.h"

#include <catch2/catch.hpp>

#include "lumi/baker/chord.h"

namespace lumi::quality
{

namespace
{

baker::Scene test_scene()
{
    std::vector<std::string> warnings;
    return baker::load_scene(LUMI_TEST_SCENE, {}, warnings);
}

}  // namespace

TEST_CASE("the chord baseline is the largest that fits")
{
    for (const uint64_t bytes : {100000ull, 524288ull, 4000000ull}) {
        const auto size = [](uint32_t side) {
            baker::BakeSettings settings;
            settings.origins = settings.directions = side;
            settings.texel = TexelFormat::palette8;
            return baker::field_file_bytes(settings);
        };
        const uint32_t side = chord_side(bytes);
        CHECK(size(side) <= bytes);
        CHECK(size(side + 1) > bytes);
    }
    CHECK(chord_side(10) == 0);
}

TEST_CASE("sprites need room for one")
{
    const baker::Scene scene = test_scene();
    CHECK(measured_sprites(scene, 5699, {}, {}, {}).empty());
    const auto views = held_out_views(ViewSet::all, 1);
    const auto references = references_of(scene, views, {1, 1, 0}, {});
    BaselineSettings settings;
    settings.sprite_samples = 1;
    constexpr uint64_t kRoom = 2 * 120 * 120;  // for one of 120 pixels a side, two of 80, or five of JPEG
    const auto sheets = measured_sprites(scene, kRoom, settings, views, references);
    REQUIRE(sheets.size() == 2);
    CHECK(sheets[0].flash_bytes <= kRoom);
    CHECK(sheets[0].flash_bytes >= 2 * 2 * 80 * 80);
    CHECK(sheets[0].pictures.size() == 1);
    CHECK(sheets[1].layout == "JPEG sprites");
    CHECK(sheets[1].flash_bytes == 5 * 5700);
}

}  // namespace lumi::quality
