// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "image/tone.h"
#include "lumi/baker/reference.h"
#include "lumi/surface/field.h"
#include "lumi/twin/surface_picture.h"
#include "math/vec3.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr int kViewSide = 48;

Vec3q30 q30(const Vec3& v)
{
    const auto number = [](float c) { return static_cast<int32_t>(std::lround(static_cast<double>(c) * kOneQ30)); };
    return {number(v.x), number(v.y), number(v.z)};
}

// From 3 radii towards the centre.
Pose pose_from(const Vec3& direction)
{
    const Vec3 back = normalized(direction), right = normalized(cross({0, 0, 1}, back));
    const auto q20 = [](float c) { return static_cast<int32_t>(std::lround(c * 3 * 1048576)); };
    return {{q20(back.x), q20(back.y), q20(back.z)}, q30(right), q30(cross(back, right)), q30(-back)};
}

Image picture_size()
{
    Image image;
    image.width_px = image.height_px = kViewSide;
    image.fov_turns32 = uint32_t{1} << 29;  // an eighth of a turn
    return image;
}

const Vec3 kViews[] = {{1, 0.3f, 0.4f}, {-0.4f, 1, 0.1f}, {-0.5f, -0.6f, 1}};

// The worst level, over pixels that are covered whole.
double worst_level(const SurfaceBake& bake, const Rgb8& truth)
{
    double worst = 0;
    for (const Vec3& from : kViews) {
        const twin::SurfacePicture p =
            twin::draw_surface(bake.file.data(), pose_from(from), picture_size(), {}, {0, 0, 0});
        size_t covered = 0;
        for (size_t k = 0; k < p.colours.size(); ++k) {
            if (p.coverage[k] == 1) {
                const twin::Colour& c = p.colours[k];
                worst = std::max({worst, std::abs(c.r - truth.r), std::abs(c.g - truth.g), std::abs(c.b - truth.b)});
                ++covered;
            }
        }
        REQUIRE(covered > 200);
    }
    return worst;
}

// Over pixels that are covered whole.
twin::Colour mean_colour(const SurfaceBake& bake)
{
    twin::Colour sum;
    double count = 0;
    for (const Vec3& from : kViews) {
        const twin::SurfacePicture p =
            twin::draw_surface(bake.file.data(), pose_from(from), picture_size(), {}, {0, 0, 0});
        for (size_t k = 0; k < p.colours.size(); ++k) {
            if (p.coverage[k] == 1) {
                sum = {sum.r + p.colours[k].r, sum.g + p.colours[k].g, sum.b + p.colours[k].b};
                ++count;
            }
        }
    }
    return {sum.r / count, sum.g / count, sum.b / count};
}

// The mean squared error of pixels that both show whole.
double squared_error(const Scene& scene, const SurfaceBake& bake)
{
    double sum = 0;
    size_t count = 0;
    for (const Vec3& from : kViews) {
        Camera camera;
        REQUIRE(make_camera(pose_from(from), picture_size(), camera) == CameraError::none);
        const RgbaImage truth = render_reference(scene, camera, {32, 1, 1});
        const twin::SurfacePicture p =
            twin::draw_surface(bake.file.data(), pose_from(from), picture_size(), {}, {0, 0, 0});
        for (size_t k = 0; k < p.colours.size(); ++k) {
            if (p.coverage[k] == 1 && truth.rgba[4 * k + 3] == 255) {
                const double d[] = {p.colours[k].r - truth.rgba[4 * k], p.colours[k].g - truth.rgba[4 * k + 1],
                                    p.colours[k].b - truth.rgba[4 * k + 2]};
                sum += d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                ++count;
            }
        }
    }
    return sum / static_cast<double>(count);
}

Scene ball(const Material& material, const Environment& environment)
{
    SceneMaker maker;
    maker.ball(maker.add(material), {0, 0, 0}, 0.7f, 12);
    maker.span_unit_sphere();
    return maker.make(environment);
}

// A field of one thread.
const SurfaceBake& tiny_bake()
{
    static const SurfaceBake bake = surface_field(tiny_scene(), {tiny_surface()});
    return bake;
}

// A level square with a sun straight above it that gives its upper side a radiance of 0.4.
Scene sheet_below_the_sun()
{
    SceneMaker maker;
    maker.quad(maker.add(diffuse(grey(0.8f))), {-0.6f, -0.6f, 0}, {0.6f, -0.6f, 0}, {0.6f, 0.6f, 0}, {-0.6f, 0.6f, 0});
    maker.add(DirectionalLight{{0, 0, 1}, grey(0.5f * 3.14159265f)});
    maker.span_unit_sphere();
    return maker.make(constant_environment(0));
}

// The mean green level over pixels that are covered whole, seen from `elevation` degrees above the sheet.
double mean_level(const SurfaceBake& bake, float elevation)
{
    const float angle = elevation * 0.0174533f;
    const Vec3 from = {std::cos(angle), 0, std::sin(angle)};
    const twin::SurfacePicture p = twin::draw_surface(bake.file.data(), pose_from(from), picture_size(), {}, {0, 0, 0});
    double sum = 0;
    size_t covered = 0;
    for (size_t k = 0; k < p.colours.size(); ++k) {
        if (p.coverage[k] == 1) {
            sum += p.colours[k].g;
            ++covered;
        }
    }
    REQUIRE(covered > 10);
    return sum / static_cast<double>(covered);
}

// Whether a triangle of a level sheet faces up.
bool faces_up(const SurfaceField& field, uint32_t triangle)
{
    const detail::SurfacePatch patch = detail::surface_patch(field, triangle / 2);
    const bool is_second = triangle % 2 != 0;
    const auto corner = [&](uint32_t k) { return detail::surface_vertex(field, patch.corner[k]); };
    const detail::VertexQ14 a = corner(is_second ? 3 : 0), b = corner(is_second ? 2 : 1), c = corner(is_second ? 1 : 2);
    return (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
}

}  // namespace

TEST_CASE("a glowing ball has its colour everywhere, from wherever it is seen", "[statistics]")
{
    const Rgb radiance = {0.6f, 0.2f, 0.05f};
    const SurfaceBake bake = surface_field(ball(lamp(radiance), constant_environment(0)), {tiny_surface()});
    CHECK(worst_level(bake, srgb_encode(radiance)) <= 1);
    CHECK(bake.viewed_vertices == 0);
}

TEST_CASE("each side of a sheet has the light that falls on it, from however flat it is seen", "[statistics]")
{
    const SurfaceBake bake = surface_field(sheet_below_the_sun(), {tiny_surface()});
    const double lit = srgb_encode(grey(0.4f)).g;
    for (const float elevation : {60.0f, 20.0f, 8.0f, 4.0f}) {
        INFO(elevation << " degrees");
        CHECK(mean_level(bake, elevation) == Approx(lit).margin(6));
        CHECK(mean_level(bake, -elevation) < 6);
    }
}

TEST_CASE("what lies across an edge of a sheet is on the same side of it")
{
    const SurfaceBake bake = surface_field(sheet_below_the_sun(), {tiny_surface()});
    SurfaceField field;
    REQUIRE(open_surface(bake.file.data(), bake.file.size(), field) == FieldError::none);
    uint32_t across = 0;
    for (uint32_t p = 0; p < field.patch_count; ++p) {
        const bool is_alone = detail::surface_patch(field, p).corner[3] == detail::format::kNoVertex;
        for (uint32_t k = 0; k < (is_alone ? 3 : 4); ++k) {
            const uint8_t* at = field.neighbours + detail::format::kNeighbourBytes * p + 2 * k;
            const uint32_t neighbour = static_cast<uint32_t>(at[0] | at[1] << 8) & detail::format::kNeighbourMask;
            if (neighbour == detail::format::kNoNeighbour) continue;
            ++across;
            CHECK(faces_up(field, neighbour) == faces_up(field, 2 * p));
        }
    }
    CHECK(across > field.patch_count);  // most sides are within the sheet
}

TEST_CASE("noise does not darken: a matt ball below an even sky has the colour of its albedo", "[statistics]")
{
    const Rgb albedo = {0.5f, 0.25f, 0.1f};
    const SurfaceBake bake = surface_field(ball(diffuse(albedo), constant_environment(1)), {tiny_surface()});
    const twin::Colour mean = mean_colour(bake);
    const Rgb8 truth = srgb_encode(albedo);
    CHECK(mean.r == Approx(truth.r).margin(0.7));
    CHECK(mean.g == Approx(truth.g).margin(0.7));
    CHECK(mean.b == Approx(truth.b).margin(0.7));
}

TEST_CASE("light above white shows as white", "[statistics]")
{
    const SurfaceBake bake = surface_field(ball(lamp({40, 1.5f, 0.2f}), constant_environment(0)), {tiny_surface()});
    CHECK(worst_level(bake, {255, 255, srgb_encode(grey(0.2f)).b}) <= 1);
}

TEST_CASE("a surface file opens in core and says what the bake says")
{
    const SurfaceBake& bake = tiny_bake();
    SurfaceField field;
    REQUIRE(open_surface(bake.file.data(), bake.file.size(), field) == FieldError::none);
    REQUIRE(verify_field(bake.file.data(), bake.file.size()) == FieldError::none);
    CHECK(field.vertex_count == bake.vertices);
    CHECK(field.viewed_count == bake.viewed_vertices);
    CHECK(field.texel_bytes == bake.texels);
}

TEST_CASE("view tables take most of the error that highlights on a metal box make", "[statistics]")
{
    SceneMaker maker;
    maker.box(maker.add(metal({0.8f, 0.5f, 0.3f}, 0.4f)), {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
    maker.add(SphereLight{{3, 1, 3}, 0.5f, {60, 60, 60}});
    maker.span_unit_sphere();
    const Scene scene = maker.make(constant_environment(0.3f));
    SurfaceSettings s = tiny_surface();
    s.longest_edge = 0.35f;
    s.paths_per_texel = 400;
    SurfacePlan plan = planned(scene, s);
    const SurfaceBake with = surface_field(scene, plan);
    plan.settings.view_tables = false;
    const SurfaceBake without = surface_field(scene, plan);
    CHECK(with.viewed_vertices > 50);
    CHECK(without.viewed_vertices == 0);
    const double error_with = squared_error(scene, with), error_without = squared_error(scene, without);
    CAPTURE(error_with, error_without);
    CHECK(error_with < error_without / 2);
}

TEST_CASE("any number of threads makes the same surface file", "[repeated]")
{
    SurfaceSettings three = tiny_surface();
    three.threads = 3;
    CHECK((surface_field(tiny_scene(), {three}).file == tiny_bake().file));
}

}  // namespace lumi::baker::testing
