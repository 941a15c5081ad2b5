// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "image/tone.h"
#include "lumi/orbit.h"
#include "lumi/surface/render.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr int32_t kPictureSide = 48;
constexpr float kPane = 0.25f;  // opacity

Material see_through(Material material, float opacity)
{
    material.opacity = opacity;
    material.finish();
    return material;
}

// A pane above a glowing square that lies below its middle.
Scene above_square(const Material& material)
{
    SceneMaker maker;
    const uint32_t below = maker.add(lamp({0.5f, 0.2f, 0.1f})), pane = maker.add(material);
    maker.quad(below, {-0.4f, -0.4f, -0.4f}, {0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, -0.4f}, {-0.4f, 0.4f, -0.4f});
    maker.quad(pane, {-0.7f, -0.7f, 0}, {0.7f, -0.7f, 0}, {0.7f, 0.7f, 0}, {-0.7f, 0.7f, 0});
    maker.span_unit_sphere();
    return maker.make(constant_environment(0));
}

// It glows itself.
Scene pane_above_square()
{
    return above_square(see_through(lamp(grey(0.3f)), kPane));
}

// Its field by one thread.
const SurfaceBake& pane_bake()
{
    static const SurfaceBake bake = surface_field(pane_above_square(), {tiny_surface()});
    return bake;
}

// The colour in a picture over black from above, so many pixels to the right of its middle.
Rgb8 colour_from_above(const SurfaceBake& bake, int32_t right_px)
{
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bake.file.data(), bake.file.size(), field) == FieldError::none);
    REQUIRE(field.see_through_count != 0);
    SurfaceCamera camera;
    const Orbit orbit = {0, uint32_t{1} << 30, radii(3)};
    REQUIRE(make_surface_camera(pose_of(orbit), image_of(orbit, kPictureSide, kPictureSide), camera) ==
            CameraError::none);
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(kPictureSide, 4));
    std::vector<uint32_t> see_through(see_through_words(field.see_through_count));
    const SurfaceMemory memory = {vertices.data(), links.data(), bands.data(), 4, see_through.data()};
    SurfaceFrame frame;
    prepare_surface<PixelRgb888, SurfaceMode::two_by_two, SurfaceFeatures::all>(field, camera, SurfaceMode::one_sample,
                                                                                memory, frame);
    std::vector<uint32_t> samples(surface_stripe_bytes(kPictureSide, kPictureSide, SurfaceMode::one_sample) / 4 + 1);
    std::vector<uint8_t> pixels(3 * kPictureSide * kPictureSide);
    render_surface<PixelRgb888, SurfaceMode::two_by_two, SurfaceFeatures::all>(
        frame, OverBlack{}, {pixels.data(), 0, 0, kPictureSide, kPictureSide, 3 * kPictureSide}, samples.data());
    return PixelRgb888::load(
        &pixels[static_cast<size_t>(3 * (kPictureSide / 2 * kPictureSide + kPictureSide / 2 + right_px))]);
}

void check_near(const Rgb8& shown, const Rgb8& wanted, int most = 4)
{
    INFO(int{shown.r} << ' ' << int{shown.g} << ' ' << int{shown.b} << " for " << int{wanted.r} << ' ' << int{wanted.g}
                      << ' ' << int{wanted.b});
    CHECK(std::abs(shown.r - wanted.r) <= most);
    CHECK(std::abs(shown.g - wanted.g) <= most);
    CHECK(std::abs(shown.b - wanted.b) <= most);
}

}  // namespace

TEST_CASE("what stands behind a pane is seen through it in the light of both, and the background by its coverage")
{
    const SurfaceBake& bake = pane_bake();
    const auto through = [](float behind) { return kPane * 0.3f + (1 - kPane) * behind; };
    check_near(colour_from_above(bake, 0), srgb_encode({through(0.5f), through(0.2f), through(0.1f)}));
    const uint8_t own = srgb_encode(grey(0.3f)).g;
    const auto level = static_cast<uint8_t>(std::lround(kPane * static_cast<float>(own)));
    check_near(colour_from_above(bake, 11), {level, level, level});
}

TEST_CASE("a coloured pane gives its hue to what stands behind it")
{
    Material glass = diffuse(grey(0));
    glass.thin = true;
    for (const Rgb& tint : {Rgb{0.2f, 0.7f, 0.3f}, Rgb{0.02f, 0.02f, 0.05f}}) {
        glass.tint = tint;
        glass.finish();
        const SurfaceBake bake = surface_field(above_square(glass), {tiny_surface()});
        // A texel's line of levels stands for the square and for the background of other views at once.
        check_near(colour_from_above(bake, 0), srgb_encode(Rgb{0.5f, 0.2f, 0.1f} * tint), 6);
    }
}

TEST_CASE("see-through parts get the same bytes with any number of threads", "[repeated]")
{
    SurfaceSettings settings = tiny_surface();
    settings.threads = 3;
    CHECK((surface_field(pane_above_square(), {settings}).file == pane_bake().file));
}

TEST_CASE("a scene of nothing but see-through parts has its far sides, too")
{
    SceneMaker maker;
    maker.ball(maker.add(see_through(lamp(grey(0.5f)), 0.4f)), {0, 0, 0}, 0.7f, 8);
    maker.span_unit_sphere();
    const SurfaceBake bake = surface_field(maker.make(constant_environment(0)), {tiny_surface()});
    const float level = static_cast<float>(srgb_encode(grey(0.5f)).g), both = (0.4f + 0.6f * 0.4f) * level;
    const auto wanted = static_cast<uint8_t>(std::lround(both));
    check_near(colour_from_above(bake, 4), {wanted, wanted, wanted});
}

TEST_CASE("see-through parts get the triangles that opaque ones leave", "[statistics]")
{
    SceneMaker maker;
    maker.ball(maker.add(see_through(lamp(grey(0.5f)), 0.4f)), {0, 0, 0}, 0.7f, 12);
    maker.span_unit_sphere();
    SurfaceSettings settings = tiny_surface();
    settings.triangles = 2000;
    settings.longest_edge = 2;
    const Scene scene = maker.make(constant_environment(0));
    const auto whole = static_cast<uint32_t>(2 * scene.data().mesh.triangle_count());  // from both sides
    CHECK(planned(scene, settings).triangles == whole);
    settings.triangles = whole / 2;
    const uint32_t half = planned(scene, settings).triangles;
    CHECK(half <= whole / 2);
    CHECK(half > whole / 3);
}

TEST_CASE("bodies of glass stay opaque", "[statistics]")
{
    SceneMaker maker;
    maker.ball(maker.add(glass(1.5f, 0)), {0, 0, 0}, 0.7f, 8);
    maker.span_unit_sphere();
    const SurfaceBake bake = surface_field(maker.make(constant_environment(1)), {tiny_surface()});
    SurfaceField field;
    CHECK(open_surface(bake.file.data(), bake.file.size(), field) == FieldError::none);
}

}  // namespace lumi::baker::testing
