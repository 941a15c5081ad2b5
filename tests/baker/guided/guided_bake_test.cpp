// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "guided/chart_mask.h"
#include "guided/guided_writer.h"
#include "image/srgb.h"
#include "lumi/baker/bake.h"
#include "lumi/baker/guided.h"
#include "lumi/guided/guided_field.h"
#include "lumi/reference/guided_shading.h"
#include "math/sampler.h"
#include "proxy/proxy_builder.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{
namespace
{

GuidedSettings small_settings()
{
    GuidedSettings s;
    s.origins = 64;
    s.chart_size = 24;
    s.mean_resolution = 20;
    s.samples = 2;
    s.threads = 2;
    return s;
}

Scene ball_on_plate()
{
    SceneMaker maker;
    maker.ball(maker.add(glossy({0.7f, 0.3f, 0.1f}, 0.3f)), {0, 0, 0.2f}, 0.4f, 8);
    maker.box(maker.add(diffuse({0.2f, 0.5f, 0.3f})), {-0.6f, -0.6f, -0.3f}, {0.6f, 0.6f, -0.22f});
    return maker.make(constant_environment(1));
}

Scene glowing_ball(const Rgb& radiance)
{
    SceneMaker maker;
    maker.ball(maker.add(lamp(radiance)), {0, 0, 0}, 0.7f, 16);
    maker.span_unit_sphere();
    return maker.make(constant_environment(0));
}

// The field lies in the bake's bytes.
GuidedField opened(GuidedBake&&) = delete;
GuidedField opened(const GuidedBake& bake)
{
    GuidedField field;
    REQUIRE(open_guided(bake.file.data(), bake.file.size(), field) == FieldError::none);
    REQUIRE(verify_field(bake.file.data(), bake.file.size()) == FieldError::none);
    return field;
}

reference::Colour shaded(const GuidedField& field, const reference::Vec3& seen_from, const reference::Vec3& x)
{
    const std::vector<reference::Vec3> origins = reference::points(field.origins.size());
    return reference::shade(field, reference::linear_weights(origins, seen_from), x, {}).colour;
}

double worst_channel(const reference::Colour& c, const Rgb8& truth)
{
    return std::max({std::abs(c.r - truth.r), std::abs(c.g - truth.g), std::abs(c.b - truth.b)});
}

// The worst difference from `truth` at what rays towards the centre see.
double worst_on_proxy(const GuidedField& field, const Rgb8& truth)
{
    PackedProxy proxy;
    for (uint32_t k = 0; k < field.proxy.vertex_count; ++k) {
        const Triple12 v = triple12(field.proxy.vertices, k);
        proxy.vertices.push_back({v.a, v.b, v.c});
    }
    for (uint32_t k = 0; k < field.proxy.triangle_count; ++k) {
        const Triple12 t = triple12(field.proxy.triangles, k);
        proxy.triangles.push_back({t.a, t.b, t.c});
    }
    const ProxyTracer tracer(unpacked(proxy), field.proxy.two_sided);
    double worst = 0;
    for (const reference::Vec3& from : reference::points(500)) {
        const Vec3 start = {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)};
        const std::optional<Hit> hit = tracer.closest({start, -start});
        if (hit) {
            const double left = 1 - static_cast<double>(hit->distance);
            worst = std::max(worst, worst_channel(shaded(field, from, left * from), truth));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("A glowing ball has its colour everywhere", "[guided]")
{
    const Rgb radiance = {0.5f, 0.2f, 0.05f};
    const Scene scene = glowing_ball(radiance);
    GuidedSettings s = small_settings();
    SECTION("as mean and differences")
    {
        s.mean_format = format::MeanFormat::palette8;
    }
    SECTION("as mean in 5-6-5 and differences")
    {
        s.mean_format = format::MeanFormat::rgb565;
    }
    SECTION("as a mean alone")
    {
        s.texel = format::GuidedTexel::none;
    }
    SECTION("as texels of 4 bits alone")
    {
        s.mean_resolution = 0;
    }
    SECTION("as texels of 8 bits alone")
    {
        s.mean_resolution = 0;
        s.texel = format::GuidedTexel::index8;
    }
    SECTION("as mean and blocks of differences")
    {
        s.texel = format::GuidedTexel::vq8;
    }
    SECTION("as blocks alone")
    {
        s.mean_resolution = 0;
        s.texel = format::GuidedTexel::vq8;
    }
    const GuidedBake bake = guided_field(scene, s);
    const GuidedField field = opened(bake);
    CHECK(bake.loss.missed < 0.01);
    CHECK(bake.loss.displaced < 0.001);
    CHECK_FALSE(bake.two_sided);
    // Two roundings of half a level each, and what the solver leaves.
    CHECK(worst_on_proxy(field, srgb_encode(radiance)) <= 1.25);
}

TEST_CASE("A refocused field shows a glowing ball that fills it", "[guided]")
{
    const Rgb radiance = {0.5f, 0.2f, 0.05f};
    GuidedSettings s = small_settings();
    s.surface = format::GuidedSurface::focus;
    s.focus_radius = 0.5f;
    const Scene scene = glowing_ball(radiance);
    const GuidedBake bake = guided_field(scene, s);
    const GuidedField field = opened(bake);
    CHECK(field.surface == format::GuidedSurface::focus);
    CHECK(std::abs(field.focus_radius_q14 - 16384 * 0.5 / static_cast<double>(scene.radius())) < 1);
    CHECK(field.mean.resolution == 0);
    double worst = 0;
    for (const reference::Vec3& from : reference::points(200)) {
        worst = std::max(worst, worst_channel(shaded(field, from, 0.5 * from), srgb_encode(radiance)));
    }
    CHECK(worst <= 0.51);
}

TEST_CASE("Guided fields are the same bytes for any number of threads", "[guided]")
{
    const Scene scene = ball_on_plate();
    GuidedSettings s = small_settings();
    s.threads = 1;
    const std::vector<uint8_t> one = guided_field(scene, s).file;
    s.threads = 3;
    CHECK(guided_field(scene, s).file == one);
    s.seed = 2;
    CHECK(guided_field(scene, s).file != one);
}

TEST_CASE("Settings choose what a guided field holds", "[guided]")
{
    const Scene scene = ball_on_plate();
    GuidedSettings s = small_settings();
    const GuidedBake whole_bake = guided_field(scene, s);
    const GuidedField whole = opened(whole_bake);
    CHECK(whole.chart.texel_count > 0);
    CHECK(whole.occlusion.texel_count > 0);
    CHECK(whole.mean.format == format::MeanFormat::palette8);

    s.occlusion = false;
    s.used_origins = 20;
    const GuidedBake cap_bake = guided_field(scene, s);
    const GuidedField cap = opened(cap_bake);
    CHECK(cap.used_origins == 20);
    CHECK(cap.occlusion.texel_count == 0);
    CHECK(cap.chart.texel_count < whole.chart.texel_count);
}

TEST_CASE("Settings that no guided field can hold are refused", "[guided]")
{
    const Scene scene = ball_on_plate();
    const auto refused = [&](auto change) {
        GuidedSettings s = small_settings();
        change(s);
        CHECK_THROWS_AS(guided_field(scene, s), BakeError);
    };
    refused([](GuidedSettings& s) { s.origins = 63; });
    refused([](GuidedSettings& s) { s.origins = 4097; });
    refused([](GuidedSettings& s) { s.used_origins = 65; });
    refused([](GuidedSettings& s) { s.chart_size = 7; });
    refused([](GuidedSettings& s) { s.chart_size = 401; });
    refused([](GuidedSettings& s) { s.samples = 0; });
    refused([](GuidedSettings& s) { s.proxy_triangles = 0; });
    refused([](GuidedSettings& s) { s.mean_resolution = 7; });
    refused([](GuidedSettings& s) {
        s.mean_resolution = 0;
        s.texel = format::GuidedTexel::none;
    });
    refused([](GuidedSettings& s) {
        s.surface = format::GuidedSurface::focus;
        s.focus = {2.0f, 0.0f, 0.0f};
    });
}

TEST_CASE("Scenes of every shape become guided fields", "[guided]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    bool two_sided = false, empty = false;
    SECTION("an open plate is seen from both sides")
    {
        maker.quad(matter, {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0});
        two_sided = true;
    }
    SECTION("a box is seen from outside")
    {
        maker.box(matter, {-0.5f, -0.3f, -0.2f}, {0.5f, 0.3f, 0.2f});
    }
    SECTION("a needle thinner than the proxy's steps leaves an empty proxy")
    {
        maker.quad(matter, {-1, 0, 0}, {1, 0, 0}, {1, 0.0001f, 0}, {-1, 0.0001f, 0});
        empty = true;
    }
    SECTION("a scene touches the sphere")
    {
        maker.ball(matter, {0.7f, 0, 0}, 0.3f, 8);
        maker.span_unit_sphere();
    }
    const GuidedBake bake = guided_field(maker.make(constant_environment(1)), small_settings());
    const GuidedField field = opened(bake);
    CHECK((bake.triangles == 0) == empty);
    CHECK((field.chart.texel_count == 0) == empty);
    if (!empty) {
        CHECK(field.proxy.two_sided == two_sided);
        CHECK(bake.loss.missed < 0.02);
    }
}

TEST_CASE("What lies behind a near surface is hidden from an origin", "[guided]")
{
    SceneMaker maker;
    const uint32_t matter = maker.add(diffuse(grey(0.5f)));
    maker.box(matter, {-0.6f, -0.6f, 0.3f}, {0.6f, 0.6f, 0.4f});
    maker.box(matter, {-0.6f, -0.6f, -0.4f}, {0.6f, 0.6f, -0.3f});
    GuidedSettings s = small_settings();
    s.chart_size = 80;  // so that blocks are smaller than the plates
    const GuidedBake bake = guided_field(maker.make(constant_environment(1)), s);
    const GuidedField field = opened(bake);
    const double scale = 1 / (1.01 * std::sqrt(0.6 * 0.6 * 2 + 0.4 * 0.4));
    // Origin 0 lies next to the north pole.
    CHECK_FALSE(reference::is_hidden(field, 0, {0, 0, 0.4 * scale}));
    CHECK(reference::is_hidden(field, 0, {0, 0, -0.3 * scale}));
    const uint32_t south = field.origins.size() - 1;
    CHECK(reference::is_hidden(field, south, {0, 0, 0.3 * scale}));
    CHECK_FALSE(reference::is_hidden(field, south, {0, 0, -0.4 * scale}));
}

TEST_CASE("Rows hold every tap of every point of the proxy", "[guided]")
{
    const Scene scene = ball_on_plate();
    const ProgressCallback silent;
    Job job(1, 2, silent);
    const BuiltProxy built = build_proxy(scene.data(), 4000, job);
    const ProxyTracer tracer(unpacked(built.proxy), built.proxy.two_sided);
    const Lattice lattice(64);
    Sampler sampler(7, 0, 0);
    uint32_t outside = 0;
    for (uint32_t origin = 0; origin < 64; origin += 3) {
        const ChartGeometry chart(lattice, origin, 60);
        const ChartRows rows = proxy_mask(chart, tracer).rows();
        const auto holds = [&](int64_t u, int64_t v) {
            const int64_t r = v - int64_t{rows.first_v};
            if (r < 0 || r >= static_cast<int64_t>(rows.rows.size())) {
                return false;
            }
            const ChartRows::Row& row = rows.rows[static_cast<size_t>(r)];
            return u >= int64_t{row.first_u} && u < int64_t{row.first_u} + row.count;
        };
        const Mesh& mesh = tracer.mesh();
        for (size_t t = 0; t < mesh.triangle_count(); ++t) {
            sampler.start(static_cast<uint32_t>(t));
            const Vec2 weights = sampler.next_2d();
            const float u = weights.x, v = weights.y * (1 - weights.x);
            const Vec3 x = mesh.position(t, 0) * (1 - u - v) + mesh.position(t, 1) * u + mesh.position(t, 2) * v;
            const Vec2 place = chart.place(x);
            const int64_t i = static_cast<int64_t>(std::floor(place.x)), j = static_cast<int64_t>(std::floor(place.y));
            outside += holds(i, j) && holds(i + 1, j) && holds(i, j + 1) && holds(i + 1, j + 1) ? 0u : 1u;
        }
    }
    CHECK(outside == 0);
}

TEST_CASE("The baker's charts are those of the renderer", "[guided]")
{
    GuidedField field;
    field.origins = Lattice(128);
    field.chart_size = 200;
    double worst = 0;
    for (uint32_t origin = 0; origin < 128; origin += 7) {
        const ChartGeometry chart(field.origins, origin, field.chart_size);
        for (const reference::Vec3& direction : reference::points(50)) {
            const reference::Vec3 x = 0.7 * direction;
            const reference::ChartPlace truth = reference::chart_place(field, origin, x);
            const Vec2 place = chart.place({static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)});
            worst = std::max({worst, std::abs(static_cast<double>(place.x) - truth.u),
                              std::abs(static_cast<double>(place.y) - truth.v)});
            const std::optional<Ray> ray = chart.ray(place);
            REQUIRE(ray);
            const reference::Vec3 e = reference::normalised(x - reference::point(128, origin));
            const double cosine = e.x * static_cast<double>(ray->direction.x) +
                                  e.y * static_cast<double>(ray->direction.y) +
                                  e.z * static_cast<double>(ray->direction.z);
            CHECK(cosine > 1 - 1e-6);
        }
    }
    INFO("grid points");
    CHECK(worst < 0.01);
}

TEST_CASE("Packed triples read back as they were written", "[guided]")
{
    GuidedParts parts;
    parts.origins = parts.used_origins = 64;
    parts.chart_size = 8;
    parts.mean.resolution = 8;
    parts.mean.box = {1, 1, 1};
    parts.mean.index = {0};
    parts.mean.bricks.assign(format::kBrickNodes, 0x1234);
    for (const size_t triangles : {0u, 1u, 2u, 5u}) {
        parts.proxy.vertices = {{0, 4095, 2048}, {1, 2, 3}, {0xABC, 0xDEF, 0x123}};
        parts.proxy.triangles.assign(triangles, {2, 0, 1});
        const std::vector<uint8_t> file = guided_file(parts);
        GuidedField field;
        REQUIRE(open_guided(file.data(), file.size(), field) == FieldError::none);
        REQUIRE(field.proxy.triangle_count == triangles);
        for (uint32_t k = 0; k < 3; ++k) {
            const Triple12 v = triple12(field.proxy.vertices, k);
            CHECK(PackedProxy::Triple{v.a, v.b, v.c} == parts.proxy.vertices[k]);
        }
        for (uint32_t k = 0; k < triangles; ++k) {
            const Triple12 t = triple12(field.proxy.triangles, k);
            CHECK(PackedProxy::Triple{t.a, t.b, t.c} == parts.proxy.triangles[k]);
        }
        CHECK(field.mean.bricks[1] == 0x12);
    }
}

}  // namespace lumi::baker::testing
