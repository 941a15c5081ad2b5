// SPDX-License-Identifier: MIT
#include "scene/light_choice.h"

#include <catch2/catch.hpp>

#include "support/shapes.h"

namespace lumi::baker
{
namespace
{

using testing::SceneMaker;

constexpr float kMiddle = 0.44f, kClayShare = 0.6f;

// A floor that a sun above lights with this irradiance, divided by π: white clay would show `light`.
void add_floor_in_sun(SceneMaker& maker, float light, const Material& material = testing::diffuse(grey(0.5f)))
{
    const uint32_t floor = maker.add(material);
    maker.quad(floor, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
    maker.add(DirectionalLight{{0, 0, 1}, grey(light * kPi)});
}

LightChoice choice_in_sun(float light, const Material& material = testing::diffuse(grey(0.5f)),
                          ToneCurve tone = ToneCurve::srgb)
{
    SceneMaker maker;
    add_floor_in_sun(maker, light, material);
    maker.see_through(tone);
    return maker.make_open().data().choice;
}

std::string text_of(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

bool has_sky(const Scene& scene)
{
    return !is_black(scene.data().lights.sky({0, 0, 1}).radiance);
}

}  // namespace

TEST_CASE("light choice: the studio lights what has no light of its own, and says so")
{
    SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 0.5f);
    const Scene scene = maker.make_open();
    CHECK(has_sky(scene));
    CHECK_THAT(text_of(scene.notes()), Catch::Contains("studio") && Catch::Contains("--sky"));
    CHECK(scene.data().choice.exposure == 1);
}

TEST_CASE("light choice: no studio beside lamps, nor beside a sky that was stated")
{
    SceneMaker lamps;
    add_floor_in_sun(lamps, 1);
    const Scene lit = lamps.make_open();
    CHECK_FALSE(has_sky(lit));
    CHECK_THAT(text_of(lit.notes()), Catch::Contains("lamps") && Catch::Contains("--sky studio"));
    SceneMaker sky;
    sky.ball(sky.add(testing::diffuse(grey(0.5f))), {}, 0.5f);
    sky.surround(constant_environment(100));
    const Scene stated = sky.make_open();
    CHECK(stated.data().lights.sky({0, 0, 1}).radiance.g == 100);
    CHECK(stated.notes().empty());
}

TEST_CASE("light choice: a display on a product leaves the studio on, a lamp that lights most of a scene does not")
{
    SceneMaker product;
    product.ball(product.add(testing::diffuse(grey(0.5f))), {}, 0.5f);
    const uint32_t display = product.add(testing::lamp(grey(1)));
    product.quad(display, {0.52f, -0.2f, -0.2f}, {0.52f, 0.2f, -0.2f}, {0.52f, 0.2f, 0.2f}, {0.52f, -0.2f, 0.2f});
    const Scene with_display = product.make_open();
    CHECK(has_sky(with_display));
    CHECK_THAT(text_of(with_display.notes()), Catch::Contains("too") && Catch::Contains("--sky black"));

    SceneMaker room;
    const uint32_t wall = room.add(testing::diffuse(grey(0.5f))), panel = room.add(testing::lamp(grey(1)));
    room.ball(wall, {0, 0, -0.2f}, 0.1f);
    room.quad(wall, {-0.5f, -0.5f, -0.4f}, {0.5f, -0.5f, -0.4f}, {0.5f, 0.5f, -0.4f}, {-0.5f, 0.5f, -0.4f});
    room.quad(panel, {-0.5f, -0.5f, 0.2f}, {0.5f, -0.5f, 0.2f}, {0.5f, 0.5f, 0.2f}, {-0.5f, 0.5f, 0.2f});
    const Scene with_panel = room.make_open();
    CHECK_FALSE(has_sky(with_panel));
    CHECK_THAT(text_of(with_panel.notes()), Catch::Contains("without the studio") && Catch::Contains("--sky studio"));
}

TEST_CASE("light choice: a glowing plate leaves the studio on, because what stands on it would be nearly black")
{
    SceneMaker maker;
    const uint32_t body = maker.add(testing::diffuse(grey(0.5f))), plate = maker.add(testing::lamp(grey(1)));
    maker.box(body, {-0.2f, -0.2f, 0}, {0.2f, 0.2f, 0.4f});
    maker.quad(plate, {-0.5f, -0.5f, -0.01f}, {0.5f, -0.5f, -0.01f}, {0.5f, 0.5f, -0.01f}, {-0.5f, 0.5f, -0.01f});
    const Scene scene = maker.make_open();
    CHECK(has_sky(scene));
    CHECK(scene.data().choice.exposure == 1);
    CHECK_THAT(text_of(scene.notes()), Catch::Contains("--sky black"));
}

TEST_CASE("light choice: clay in the studio shows the middle tone that lamps are brought to")
{
    SceneMaker maker;
    maker.ball(maker.add(testing::diffuse(grey(0.5f))), {}, 0.5f);
    const Scene scene = maker.make_open();
    const SceneData& data = scene.data();
    const float middle =
        middle_of_lit(meter({data.mesh, data.materials, data.textures, data.accelerator}, data.lights));
    CHECK(middle / kMiddle == Approx(1).margin(0.2));
}

TEST_CASE("light choice: lamps of any unit give what they light a middle tone, through every tone curve")
{
    for (const float light : {1e-4f, 0.01f, 10.0f, 3000.0f}) {
        for (const ToneCurve tone : {ToneCurve::srgb, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::agx}) {
            INFO(light);
            const LightChoice choice = choice_in_sun(light, testing::diffuse(grey(0.5f)), tone);
            const float shown = luminance(toned(tone, grey(kClayShare * light * choice.exposure)));
            CHECK(shown / kMiddle == Approx(1).margin(0.13));  // half a step: a sixth of a stop
            CHECK_THAT(text_of(choice.notes), Catch::Contains("stops") && Catch::Contains("--exposure"));
        }
    }
}

TEST_CASE("light choice: what is within a stop of it stays, and so does a stated exposure")
{
    for (const float light : {0.4f, 0.7f, 1.4f}) CHECK(choice_in_sun(light).exposure == 1);
    SceneMaker maker;
    add_floor_in_sun(maker, 1000);
    maker.expose(0.25f);
    const LightChoice stated = maker.make_open().data().choice;
    CHECK(stated.exposure == 0.25f);
    CHECK_THAT(text_of(stated.notes), !Catch::Contains("stops"));
}

TEST_CASE("light choice: colours and finishes do not change the exposure, nor does glass before them")
{
    const float exposure = choice_in_sun(50).exposure;
    CHECK(choice_in_sun(50, testing::diffuse(grey(0.01f))).exposure == exposure);
    CHECK(choice_in_sun(50, testing::metal(grey(1), 0.1f)).exposure == exposure);
    SceneMaker maker;
    add_floor_in_sun(maker, 50);
    maker.ball(maker.add(testing::glass(1.5f, 0)), {0, 0, 0.2f}, 0.15f);
    CHECK(maker.make_open().data().choice.exposure == exposure);
}

TEST_CASE("light choice: the exposure multiplies lamps, picture and what shines alike")
{
    SceneMaker maker;
    add_floor_in_sun(maker, 80);
    maker.add(testing::lamp(grey(3)));
    const Scene scene = maker.make_open();
    const float exposure = scene.data().choice.exposure;
    CHECK(exposure < 0.02f);
    CHECK(scene.data().materials[1].emission.g == 3 * exposure);
    scene.data().lights.sample({}, {{0.5f, 0.5f}, {0.5f, 0.5f}}, [&](const LightSample& sun, float) {
        CHECK(sun.radiance.g == Approx(80 * kPi * exposure));
    });
}

TEST_CASE("light choice: a scene without light, and lamps that light nothing, are warned of")
{
    SceneMaker dark;
    dark.ball(dark.add(testing::diffuse(grey(0.5f))), {}, 0.5f);
    dark.surround(constant_environment(0));
    CHECK_THAT(text_of(dark.make_open().data().choice.warnings), Catch::Contains("no light"));
    SceneMaker enclosed;
    enclosed.box(enclosed.add(testing::diffuse(grey(0.5f))), {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    enclosed.add(PointLight{{0, 0, 0}, grey(9)});
    const LightChoice choice = enclosed.make_open().data().choice;
    CHECK_THAT(text_of(choice.warnings), Catch::Contains("no lamp"));
    CHECK(choice.exposure == 1);
}

}  // namespace lumi::baker
