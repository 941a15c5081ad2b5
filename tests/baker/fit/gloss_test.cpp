// SPDX-License-Identifier: MIT
#include "fit/gloss/gloss_fit.h"

#include <catch2/catch.hpp>

#include "fit/fit_shape.h"
#include "fit/gloss/map_choices.h"
#include "image/tone.h"
#include "lumi/baker/reference.h"
#include "lumi/baker/surface.h"
#include "lumi/host/view_memory.h"
#include "lumi/surface/render.h"
#include "math/sampler.h"
#include "math/warp.h"
#include "support/shapes.h"
#include "surface/surface_scenes.h"

namespace lumi::baker::testing
{
namespace
{

constexpr int kViewedSide = 64;

Vec3q30 unit_q30(const Vec3& v)
{
    const auto number = [](float c) { return static_cast<int32_t>(std::lround(static_cast<double>(c) * kOneQ30)); };
    return {number(v.x), number(v.y), number(v.z)};
}

Pose pose_at(const Vec3& direction)
{
    const Vec3 back = normalized(direction), right = normalized(cross({0, 0, 1}, back));
    const auto q20 = [](float c) { return static_cast<int32_t>(std::lround(c * 3 * 1048576)); };
    return {{q20(back.x), q20(back.y), q20(back.z)}, unit_q30(right), unit_q30(cross(back, right)), unit_q30(-back)};
}

// As a device draws it.
std::vector<uint8_t> drawn_by_core(const SurfaceField& field, const Pose& pose, const Image& image)
{
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(kViewedSide, 4));
    std::vector<uint32_t> features(feature_words(field)),
        samples(surface_stripe_bytes(kViewedSide, kViewedSide, SurfaceMode::two_by_two) / 4 + 1);
    SurfaceCamera camera;
    REQUIRE(make_surface_camera(pose, image, camera) == CameraError::none);
    SurfaceFrame frame;
    prepare_surface<PixelRgb888, SurfaceMode::two_by_two, SurfaceFeatures::all>(
        field, camera, SurfaceMode::two_by_two, {vertices.data(), links.data(), bands.data(), 4, features.data()},
        frame);
    std::vector<uint8_t> pixels(size_t{3} * kViewedSide * kViewedSide);
    render_surface<PixelRgb888, SurfaceMode::two_by_two, SurfaceFeatures::all>(
        frame, OverBlack{}, {pixels.data(), 0, 0, kViewedSide, kViewedSide, 3 * kViewedSide}, samples.data());
    return pixels;
}

struct Likeness {
    double error;   // mean squared, of pixels that are covered whole
    double energy;  // the light of all these pixels, as a share of the truth's
};

Likeness likeness_of(const Scene& scene, const SurfaceBake& bake)
{
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bake.file.data(), bake.file.size(), field) == FieldError::none);
    Image image;
    image.width_px = image.height_px = kViewedSide;
    image.fov_turns32 = uint32_t{1} << 29;
    double sum = 0, light = 0, expected = 0, count = 0;
    for (const Vec3& from : {Vec3{1, 0.3f, 0.4f}, {-0.4f, 1, 0.1f}, {-0.5f, -0.6f, 1}}) {
        const Pose pose = pose_at(from);
        Camera camera;
        REQUIRE(make_camera(pose, image, camera) == CameraError::none);
        const RgbaImage truth = render_reference(scene, camera, {32, 1, 2});
        const std::vector<uint8_t> shown = drawn_by_core(field, pose, image);
        for (size_t k = 0; k < size_t{kViewedSide} * kViewedSide; ++k) {
            if (truth.rgba[4 * k + 3] != 255) continue;
            for (size_t c = 0; c < 3; ++c) {
                const double off = static_cast<double>(shown[3 * k + c]) - truth.rgba[4 * k + c];
                sum += off * off / 3;
                light += srgb_linear(shown[3 * k + c] / 255.0);
                expected += srgb_linear(truth.rgba[4 * k + c] / 255.0);
            }
            ++count;
        }
    }
    return {sum / count, light / expected};
}

// Beside it a knob moves.
Scene lacquered_ball(const Environment& environment)
{
    SceneMaker maker;
    const uint32_t lacquer = maker.add(glossy({0.3f, 0.02f, 0.02f}, 0.15f));
    maker.ball(lacquer, {0, 0, 0}, 0.8f, 40);
    maker.span_unit_sphere();
    PartMovement movement;
    movement.name = "knob";
    movement.axis = {0, 0, 1};
    maker.begin_part(movement);
    maker.ball(lacquer, {0.6f, 0, 0.6f}, 0.1f);
    return maker.make(environment);
}

SurfacePlan gloss_plan(const Scene& scene)
{
    SurfaceSettings s = tiny_surface();
    s.triangles = 500;
    s.longest_edge = 0.3f;
    s.texels_per_radius = 12;
    s.paths_per_texel = 30;
    s.threads = 2;
    return planned(scene, s);
}

bool has_gloss(const SurfaceBake& bake)
{
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bake.file.data(), bake.file.size(), field) == FieldError::none);
    return gloss_count(field) != 0;
}

}  // namespace

TEST_CASE("taps of gloss lie around the mirrored direction", "[fit]")
{
    Sampler sampler(3, 1, 4);
    float worst = 0;
    for (uint32_t k = 0; k < 2000; ++k) {
        sampler.start(k);
        const Vec3 normal = square_to_sphere(sampler.next_2d()), position = square_to_sphere(sampler.next_2d()) * 0.9f,
                   eye = square_to_sphere(sampler.next_2d()) * 3, to_eye = normalized(eye - position);
        if (dot(normal, to_eye) < 0.3f) continue;
        const Vec3 mirrored = normal * (2 * dot(normal, to_eye)) - to_eye;
        const GlossCorner corner = {position, normal, 1.0f / 3};
        const GlossTaps taps = gloss_taps({corner, corner, corner}, eye);
        Vec3 mean;
        float all = 0;
        for (size_t t = 0; t < 4; ++t) {
            constexpr uint32_t kTexels = detail::format::kGlossSide;
            const auto place = [](uint32_t step) { return (2 * static_cast<float>(step) + 1) / kTexels - 1; };
            Vec3 d = {place(taps.texels[t] % kTexels), place(taps.texels[t] / kTexels), 0};
            d.z = 1 - std::abs(d.x) - std::abs(d.y);
            if (d.z < 0) d = {std::copysign(1 - std::abs(d.y), d.x), std::copysign(1 - std::abs(d.x), d.y), d.z};
            mean = mean + normalized(d) * taps.weights[t];
            all += taps.weights[t];
        }
        CHECK(std::abs(all - 1) < 1e-4f);
        worst = std::max(worst, length(normalized(mean) - mirrored));
    }
    CHECK(worst < 0.06f);  // half a texel is 4°
}

TEST_CASE("a lacquered ball mirrors soft boxes by a gloss map, which takes most of the error away", "[statistics]")
{
    const Scene scene = lacquered_ball(studio_environment());
    SurfacePlan plan = gloss_plan(scene);
    const SurfaceBake with = surface_field(scene, plan);
    REQUIRE(has_gloss(with));
    plan.settings.draft = true;  // a first look has none
    const SurfaceBake without = surface_field(scene, plan);
    CHECK(!has_gloss(without));
    const Likeness likeness = likeness_of(scene, with), before = likeness_of(scene, without);
    INFO(likeness.error << " for " << before.error << ", light " << likeness.energy << " for " << before.energy);
    CHECK(likeness.error < 0.6 * before.error);
    // Where highlights clip, blurred ones hold more of what is shown; maps add nothing to that.
    CHECK(std::abs(likeness.energy - 1) < std::abs(before.energy - 1));
    CHECK(std::abs(likeness.energy - 1) < 0.05);
    plan.settings.draft = false;
    plan.settings.threads = 1;
    CHECK((surface_field(scene, plan).file == with.file));
}

TEST_CASE("patches of a material that mirror more and less get maps of their own", "[fit]")
{
    const Scene scene = lacquered_ball(studio_environment());
    const SurfacePlan plan = gloss_plan(scene);
    const PatchMesh& mesh = plan.mesh->mesh;
    const FitShape shape(mesh, std::vector<float>(mesh.patches.size(), 12));
    Sampler sampler(3, 1, 4);
    std::vector<GlossLine> lines;
    for (uint32_t k = 0; k < 30 * mesh.patches.size(); ++k) {
        sampler.start(k);
        const uint32_t patch = k / 30;
        const Vec3 normal = mesh.normals[shape.vertex(patch, 0)];
        lines.push_back({2 * patch,
                         patch,
                         0,
                         0.3f,
                         0.3f,
                         normalized(normal + square_to_sphere(sampler.next_2d())) * 3,
                         normal,
                         {},
                         0});
    }
    const std::vector<uint8_t> all(mesh.patches.size(), 1);
    const GlossEquations equations(shape, lines, mesh.normals, all, 1);
    GlossColours unknowns(equations.unknowns());
    for (size_t k = equations.nodes(); k < unknowns.size(); ++k)
        unknowns[k] = {static_cast<float>(k % 7) * 10, static_cast<float>(k % 5) * 10, 3};
    GlossColours levels = equations.shown(unknowns);
    for (size_t k = 0; k < lines.size(); ++k) {
        const float factor = lines[k].texel % 2 == 0 ? 1.6f : 0.1f;
        for (float& level : levels[k]) level *= factor;
    }
    const std::vector<uint8_t> split = split_choices(equations, unknowns, levels, lines, all, 2);
    for (size_t p = 0; p < split.size(); ++p) CHECK(split[p] == p % 2 + 1);
    CHECK(split_choices(equations, unknowns, levels, lines, all, 1) == all);
    CHECK(split_choices(equations, unknowns, equations.shown(unknowns), lines, all, 2) == all);
    // Apart from each other each takes what suits it; side by side they rather take the same.
    PatchMesh apart = mesh;
    for (PatchMesh::Patch& p : apart.patches) p = {0, 0, 0, 0};
    const std::vector<uint8_t> chosen = choices_among({1}, equations, unknowns, levels, lines, apart, all);
    for (size_t p = 0; p < chosen.size(); ++p) CHECK(chosen[p] == (p + 1) % 2);
    GlossColours all_but_one = equations.shown(unknowns);
    for (size_t k = 0; k < lines.size(); ++k)
        if (lines[k].texel == 7) all_but_one[k] = {0, 0, 0};
    CHECK(choices_among({1}, equations, unknowns, all_but_one, lines, apart, all)[7] == 0);
    CHECK(choices_among({1}, equations, unknowns, all_but_one, lines, mesh, all)[7] == 1);
}

TEST_CASE("gloss maps keep to the limits of bytes and of RAM: as many are fitted as there is room for", "[fit]")
{
    const Scene scene = lacquered_ball(studio_environment());
    const host::ScreenSize screen = {160, 160, 8};
    const auto within = [&](uint64_t bytes, uint64_t ram) {
        SurfaceLimits limits;
        limits.bytes = bytes;
        limits.ram = RamLimit{ram, screen};
        limits.chooses_triangles = limits.chooses_edge = false;
        SurfaceSettings settings = gloss_plan(scene).settings;
        settings.triangles = 60;
        settings.longest_edge = 0.8f;
        settings.paths_per_texel = 2;
        return plan_surface(scene, settings, limits);
    };
    const uint64_t much = 1'000'000;
    const SurfacePlan roomy = within(60'000, much), few = within(8'000, much);
    CHECK(roomy.settings.gloss_maps == 3);
    CHECK(few.settings.gloss_maps < 3);
    CHECK_FALSE(few.fewer_maps);  // for bytes, not for RAM
    const SurfacePlan plan = within(8'000, few.ram_bytes - 1);
    CHECK(plan.settings.gloss_maps == few.settings.gloss_maps - 1);
    CHECK(plan.fewer_maps);
    const SurfaceBake bake = surface_field(scene, few);
    SurfaceField field;
    REQUIRE(open_surface<SurfaceFeatures::all>(bake.file.data(), bake.file.size(), field) == FieldError::none);
    CHECK(gloss_count(field) == few.settings.gloss_maps);
    CHECK(bake.file.size() <= few.most_bytes);
    CHECK(few.most_bytes <= 8'000);
    CHECK(host::surface_view_bytes<PixelRgb565>(host::counts_of(field, SurfaceMode::antialiased), screen) +
              host::stripe_pixel_bytes<PixelRgb565>(screen) <=
          few.ram_bytes);
}

TEST_CASE("what lies behind a pane has the map that it has without the pane, which is drawn over it", "[fit]")
{
    const auto maps_behind = [](bool pane) {
        SceneMaker maker;
        maker.ball(maker.add(glossy({0.3f, 0.02f, 0.02f}, 0.15f)), {0, 0, 0}, 0.6f, 40);
        Material glass = diffuse(grey(0.02f));
        glass.opacity = 0.4f;
        if (pane) maker.box(maker.add(glass), {-0.62f, -0.62f, -0.62f}, {0.62f, 0.62f, 0.62f});
        maker.span_unit_sphere();
        const Scene scene = maker.make(studio_environment());
        const SurfacePlan plan = gloss_plan(scene);
        const BuiltMesh& built = *plan.mesh;
        const FitShape shape(built.mesh, std::vector<float>(built.mesh.patches.size(), 12));
        BakeStages stages({}, {});
        return gloss_of(scene.data(), shape, plan.settings, stages, {}).maps;
    };
    const std::vector<GlossMap> without = maps_behind(false), with = maps_behind(true);
    REQUIRE(without.size() == 1);
    REQUIRE(with.size() == 1);
    for (size_t c = 0; c < 3; ++c) CHECK(std::abs(with[0].gains[c] - without[0].gains[c]) <= without[0].gains[c] / 5);
}

TEST_CASE("gloss that a file states is sound on opaque patches of the body of a shiny mesh alone", "[fit]")
{
    const Scene scene = lacquered_ball(studio_environment());
    PatchMesh mesh = gloss_plan(scene).mesh->mesh;
    Gloss gloss;
    gloss.maps.emplace_back();
    gloss.maps[0].texels.resize(detail::format::kGlossMapBytes);
    gloss.choices.assign(mesh.patches.size(), 0);
    gloss.normals.assign(mesh.positions.size(), {0, 0, 1});
    gloss.choices[0] = 1;
    CHECK(is_sound(gloss, mesh));
    REQUIRE(mesh.owner_of(static_cast<uint32_t>(mesh.patches.size() - 1)) == 1);
    gloss.choices.back() = 1;  // of the knob
    CHECK(!is_sound(gloss, mesh));
    gloss.choices.back() = 0;
    mesh.is_matt = 1;
    CHECK(!is_sound(gloss, mesh));
}

TEST_CASE("there is no gloss map where nothing that is mirrored has edges, or view tables are left out", "[fit]")
{
    const Scene even = lacquered_ball(gradient_environment()), boxes = lacquered_ball(studio_environment());
    const PatchMesh mesh;
    SurfaceSettings settings;
    CHECK(may_gloss(boxes.data(), mesh, settings));
    CHECK(!may_gloss(even.data(), mesh, settings));
    settings.view_tables = false;
    CHECK(!may_gloss(boxes.data(), mesh, settings));
}

}  // namespace lumi::baker::testing
