// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_shade.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "guided/guided_bytes.h"
#include "guided/opened_guided.h"
#include "lumi/guided/guided_vq.h"
#include "lumi/reference/guided_shading.h"
#include "reference.h"
#include "report.h"

using namespace lumi;
using namespace lumi::test;
using format::GuidedSurface;
using format::GuidedTexel;
using format::MeanFormat;
using reference::Vec3;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr uint32_t kPoints = 300;
#else
constexpr uint32_t kPoints = 40000;
#endif

double uniform(std::minstd_rand& random, double low, double high)
{
    return low + (high - low) * std::generate_canonical<double, 32>(random);
}

SurfacePoint random_point(std::minstd_rand& random, double largest)
{
    for (;;) {
        const Vec3 x = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
        if (reference::dot(x, x) > 1) continue;
        const auto q14 = [&](double v) { return static_cast<int32_t>(std::lround(v * largest * 16384)); };
        return {q14(x.x), q14(x.y), q14(x.z), 1};
    }
}

Vec3 decoded_point(const SurfacePoint& x)
{
    return {x.x_q14 / 16384.0, x.y_q14 / 16384.0, x.z_q14 / 16384.0};
}

// A triangle of origins with weights that sum to 256.
OriginTaps random_taps(const GuidedField& field, std::minstd_rand& random)
{
    const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * reference::kPi);
    const double r = std::sqrt(1 - z * z);
    const Triangle t = triangle(field.origins, reference::encoded({r * std::cos(angle), r * std::sin(angle), z}));
    OriginTaps taps;
    for (int k = 0; k < 3; ++k) taps.index[k] = static_cast<int32_t>(t.index[k]);
    taps.weight_q8[1] = t.weight_q12[1] >> 4;
    taps.weight_q8[2] = t.weight_q12[2] >> 4;
    taps.weight_q8[0] = 256 - taps.weight_q8[1] - taps.weight_q8[2];
    return taps;
}

reference::Weights weights_of(const OriginTaps& taps)
{
    reference::Weights weights;
    for (int k = 0; k < 3; ++k) weights.emplace_back(static_cast<uint32_t>(taps.index[k]), taps.weight_q8[k] / 256.0);
    return weights;
}

double worst_channel(const Rgb8& a, const reference::Colour& b)
{
    return std::max({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)});
}

// A field whose chart colours and voxels vary smoothly, so that a difference in place shows as a small one in colour.
TestMean smooth_mean(MeanFormat format)
{
    TestMean mean;
    mean.format = format;
    mean.resolution = 24;
    mean.first_brick = {0, 1, 0};
    mean.box = {6, 5, 6};
    mean.bricks = 180;
    return mean;
}

uint8_t smooth_texel(uint32_t origin, uint32_t number, uint32_t entries)
{
    const uint32_t u = number % 53, v = number / 53;
    const uint32_t wave = (origin * 3 + u + v) % (2 * entries - 2);
    return static_cast<uint8_t>(wave < entries ? wave : 2 * entries - 2 - wave);
}

Bytes smooth_field(const TestGuided& g, const TestMean* mean, bool occlusion)
{
    std::vector<TestSection> sections = {guided_section(g)};
    if (g.surface == GuidedSurface::proxy) sections.push_back(proxy_section(tetrahedron()));
    if (mean != nullptr) {
        const bool indexed = mean->format == MeanFormat::palette8;
        // Neighbours differ by up to a quarter of the range, at random.
        const auto node = [&](uint32_t k) {
            const uint32_t h = (indexed ? k : k / 2) * 2654435761u >> 16;
            const uint32_t v = (10 + h % 8) << 11 | (20 + h / 8 % 16) << 5 | (8 + h / 128 % 8);
            return static_cast<uint8_t>(indexed ? 90 + h % 64 : k % 2 == 0 ? v : v >> 8);
        };
        sections.push_back(mean_section(
            *mean, [](uint32_t k) { return k; }, node));
    }
    if (g.texel == GuidedTexel::none) return file_of(sections);
    const bool nibbles = g.texel == GuidedTexel::index4;
    const bool blocks = g.texel == GuidedTexel::vq8;
    const uint32_t entries = nibbles ? 16 : 256;
    const std::vector<TestChartRows> charts(g.used_origins, full_chart_rows(g));
    sections.push_back(table_section(format::kChartSection, nibbles, charts,
                                     [&](uint32_t i, uint32_t k) { return smooth_texel(i, k, entries); }));
    sections.push_back(chart_colours_section(g, [&](uint32_t, uint32_t k) {
        // The corners of a block are further apart than the tolerance.
        const uint32_t level = blocks ? k / 16 + 12 * (k % 4) : k * 256 / entries;
        return level | (255 - level) << 8 | (level / 2) << 16;
    }));
    if (occlusion) sections.push_back(occlusion_section(g));
    return file_of(sections);
}

// Compares a policy with the double-precision reconstruction at random points and triangles. A point on the edge of a
// tap's or a block's cell may fall to the other side: `most` of them must agree.
template <class Policy>
void compare(const GuidedField& field, const reference::GuidedShading& shading, double tolerance, double most)
{
    REQUIRE(Policy::fits(field));
    std::minstd_rand random(5);
    OriginCharts charts(field);
    const GuidedShader<Policy> shader(field);
    double sum = 0;
    uint32_t agree = 0;
    Worst worst;
    for (uint32_t n = 0; n < kPoints; ++n) {
        const SurfacePoint x = random_point(random, 0.75);
        const OriginTaps taps = random_taps(field, random);
        Policy::Origins::hold(charts, taps, true);
        const Shade shade = shader.shade(x, charts, taps);
        const reference::Shade exact = reference::shade(field, weights_of(taps), decoded_point(x), shading);
        double error = std::fabs(shade.coverage_q8 / 256.0 - exact.coverage) * 255;
        if (exact.coverage > 0.05) error = std::max(error, worst_channel(shade.colour, exact.colour));
        sum += error;
        agree += error <= tolerance ? 1 : 0;
        worst.see(error, n);
    }
    worst.report("shade against double precision");
    std::printf("  mean of worst channels %.3f levels, within %.1f: %.4f\n", sum / kPoints, tolerance,
                static_cast<double>(agree) / kPoints);
    CHECK(sum / kPoints < 1.25);
    CHECK(agree >= most * kPoints);
}

constexpr reference::GuidedShading kBest = {reference::Origins::three, reference::Taps::linear};
constexpr OcclusionUse kRead = OcclusionUse::read;

}  // namespace

TEST_CASE("a place in a chart is within 1/16 grid point of the real one", "[guided]")
{
    const uint32_t size = GENERATE(8u, 61u, 128u, 400u);
    std::minstd_rand random(size);
    TestGuided g;
    g.chart_size = size;
    g.texel = GuidedTexel::none;
    const TestMean mean = smooth_mean(MeanFormat::rgb565);
    const OpenedGuided opened(smooth_field(g, &mean, false));
    Worst worst, near;
    for (uint32_t n = 0; n < kPoints; ++n) {
        const uint32_t origin = static_cast<uint32_t>(n % g.origins);
        const Vec3q30 p = point(opened.field.origins, origin);
        const ChartAxes axes = chart_axes(p, chart_frame(p), size);
        const SurfacePoint x = random_point(random, 1);
        const Vec3 e = decoded_point(x) - reference::point(g.origins, origin);
        const double distance = reference::length(e);
        const ChartPlace place = chart_place(axes, squared(x), 0);
        const reference::ChartPlace exact = reference::chart_place(opened.field, origin, decoded_point(x));
        const double centre = format::chart_centre(size);
        const double error = std::max(std::fabs(place.u_q8 / 256.0 + centre - exact.u),
                                      std::fabs(place.v_q8 / 256.0 + centre - exact.v));
        CHECK(std::fabs(place.distance2_q28 / 268435456.0 - distance * distance) < 1.5e-4);
        if (distance >= 0.25)
            worst.see(error, n);
        else
            near.see(error * distance, n);
    }
    worst.report("chart place, grid points");
    near.report("chart place closer than 1/4, grid points times distance");
    CHECK(worst.error < 1.0 / 16);
    CHECK(near.error < 1.0 / 32);
}

TEST_CASE("an origin that the surface point coincides with has a place, too", "[guided]")
{
    const Vec3q30 p = {0, 0, kOneQ30};
    const ChartAxes axes = chart_axes(p, chart_frame(p), 400);
    const SurfacePoint x = {0, 0, 16384, 1};
    const ChartPlace place = chart_place(axes, squared(x), 0);
    CHECK(place.u_q8 == 0);
    CHECK(place.v_q8 == 0);
    CHECK(place.distance2_q28 == 0);
}

TEST_CASE("mean colours are trilinear within a level", "[guided]")
{
    TestGuided g;
    g.texel = GuidedTexel::none;
    const MeanFormat kind = GENERATE(MeanFormat::rgb565, MeanFormat::palette8);
    TestMean mean = smooth_mean(kind);
    const OpenedGuided opened(smooth_field(g, &mean, false));
    std::minstd_rand random(3);
    Worst worst;
    double sum = 0;
    for (uint32_t n = 0; n < kPoints; ++n) {
        const SurfacePoint x = random_point(random, n % 4 == 0 ? 2 : 1);  // some beside the box of bricks
        const LevelsQ8 levels = kind == MeanFormat::rgb565 ? MeanReader<MeanRgb565>(opened.field.mean).at(x)
                                                           : MeanReader<MeanPalette8>(opened.field.mean).at(x);
        const reference::Colour exact = reference::mean_colour(opened.field, decoded_point(x));
        const double error = std::max({std::fabs(levels.r / 256.0 - exact.r), std::fabs(levels.g / 256.0 - exact.g),
                                       std::fabs(levels.b / 256.0 - exact.b)});
        worst.see(error, n);
        sum += error;
    }
    worst.report("mean colour, levels");
    // Weights of 5-6-5 nodes are rounded to 1/64, times steps of up to 64 levels from node to node.
    CHECK(worst.error < 3);
    CHECK(sum / kPoints < 0.8);
}

TEST_CASE("shades are those of double precision, whatever a field stores", "[guided]")
{
    TestGuided g;
    g.chart_size = 40;
    const TestMean five = smooth_mean(MeanFormat::rgb565), eight = smooth_mean(MeanFormat::palette8);
    SECTION("4-bit differences over 5-6-5 voxels, with occlusion")
    {
        const OpenedGuided o(smooth_field(g, &five, true));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanRgb565, kRead>>(o.field, kBest, 4, 0.98);
    }
    SECTION("8-bit differences over palette voxels")
    {
        g.texel = GuidedTexel::index8;
        const OpenedGuided o(smooth_field(g, &eight, false));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex8, MeanPalette8, kRead>>(o.field, kBest, 4, 0.98);
    }
    SECTION("absolute colours")
    {
        const OpenedGuided o(smooth_field(g, nullptr, true));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, NoMean, kRead>>(o.field, kBest, 3, 0.98);
    }
    SECTION("coverage on a focus surface")
    {
        g.surface = GuidedSurface::focus;
        g.used_origins = 40;
        const OpenedGuided o(smooth_field(g, nullptr, false));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, NoMean, kRead>>(o.field, kBest, 4, 0.95);
    }
    SECTION("blocks of differences over palette voxels, with occlusion")
    {
        g.texel = GuidedTexel::vq8;
        const OpenedGuided o(smooth_field(g, &eight, true));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, GuidedVq8, MeanPalette8, kRead>>(o.field, kBest, 4, 0.98);
    }
    SECTION("blocks of absolute colours")
    {
        g.texel = GuidedTexel::vq8;
        g.used_origins = 50;
        const OpenedGuided o(smooth_field(g, nullptr, false));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, GuidedVq8, NoMean, kRead>>(o.field, kBest, 3, 0.98);
    }
    SECTION("blocks, one origin, nearest tap")
    {
        g.texel = GuidedTexel::vq8;
        const OpenedGuided o(smooth_field(g, &five, true));
        const reference::GuidedShading least = {reference::Origins::heaviest, reference::Taps::nearest};
        compare<GuidedPolicy<OneOrigin, NearestTap, GuidedVq8, MeanRgb565, kRead>>(o.field, least, 3, 0.94);
    }
    SECTION("the mean alone")
    {
        g.texel = GuidedTexel::none;
        const OpenedGuided o(smooth_field(g, &five, false));
        compare<GuidedPolicy<ThreeOrigins, LinearTaps, NoChart, MeanRgb565, kRead>>(o.field, kBest, 2.5, 0.999);
    }
    SECTION("one origin, nearest tap")
    {
        const OpenedGuided o(smooth_field(g, &five, true));
        const reference::GuidedShading least = {reference::Origins::heaviest, reference::Taps::nearest};
        compare<GuidedPolicy<OneOrigin, NearestTap, GuidedIndex4, MeanRgb565, kRead>>(o.field, least, 3, 0.94);
    }
    SECTION("three origins, nearest tap")
    {
        const OpenedGuided o(smooth_field(g, &five, true));
        const reference::GuidedShading nearest = {reference::Origins::three, reference::Taps::nearest};
        compare<GuidedPolicy<ThreeOrigins, NearestTap, GuidedIndex4, MeanRgb565, kRead>>(o.field, nearest, 3, 0.94);
    }
}

TEST_CASE("policies fit the fields that hold what they read", "[guided]")
{
    TestGuided g;
    const TestMean five = smooth_mean(MeanFormat::rgb565);
    const OpenedGuided full(smooth_field(g, &five, true)), bare(smooth_field(g, nullptr, false));
    using Full = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanRgb565, kRead>;
    using Bare = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, NoMean, kRead>;
    using MeanOnly = GuidedPolicy<ThreeOrigins, LinearTaps, NoChart, MeanRgb565, kRead>;
    using Wide = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex8, MeanRgb565, kRead>;
    using Palette = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanPalette8, kRead>;
    using Blocks = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedVq8, MeanRgb565, kRead>;
    CHECK(Full::fits(full.field));
    CHECK(MeanOnly::fits(full.field));
    CHECK_FALSE(Bare::fits(full.field));
    CHECK_FALSE(Wide::fits(full.field));
    CHECK_FALSE(Blocks::fits(full.field));
    CHECK_FALSE(Palette::fits(full.field));
    CHECK(Bare::fits(bare.field));
    CHECK_FALSE(Full::fits(bare.field));
}
