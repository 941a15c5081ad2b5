// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_render.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "guided/guided_drawing.h"
#include "lumi/crc32.h"
#include "lumi/guided/focus_surface.h"
#include "lumi/guided/guided_vq.h"
#include "report.h"
#include "srgb.h"

using namespace lumi;
using namespace lumi::test;
using format::GuidedTexel;
using format::MeanFormat;

namespace
{

// What a test wants a pixel to see: any function of its place.
template <uint32_t kCount, class See>
struct TestSurface {
    static constexpr uint32_t kSamples = kCount;
    See see;
    int32_t y = 0;

    void begin_stripe(const Stripe&) {}
    int32_t next(int32_t x, int32_t) const { return x; }
    RowSpan columns() const { return {0, kMaxImageSide}; }
    void begin_row(int32_t row) { y = row; }
    uint32_t at(int32_t x, SurfacePoint (&out)[kSamples]) const { return see(x, y, out); }
};

template <uint32_t kCount, class See>
TestSurface<kCount, See> seeing(See see)
{
    return {see, 0};
}

// Points anywhere within the stated range, in up to four groups a pixel.
uint32_t scattered(int32_t x, int32_t y, SurfacePoint (&out)[4])
{
    std::minstd_rand random(static_cast<uint32_t>(x * 7919 + y * 104729 + 1));
    random.discard(3);
    const uint32_t groups = static_cast<uint32_t>(random() % 5);
    const auto any = [&] { return static_cast<int32_t>(random() % 65537) - 32768; };
    for (uint32_t k = 0; k < groups; ++k)
        out[k] = {any(), any(), any(), groups == 1 ? 1 + static_cast<uint32_t>(random() % 4) : 1};
    return groups;
}

Bytes guided_file(GuidedTexel texel, MeanFormat mean_format)
{
    TestGuided g;
    g.texel = texel;
    TestMean mean;
    mean.format = mean_format;
    return sample_guided(g, tetrahedron(), mean);
}

// Draws a field with every policy that fits it, over points anywhere.
void draw_every_way(const GuidedField& field, const Camera& camera)
{
    auto surface = seeing<4>(scattered);
    const auto draw_as = [&](auto policy) {
        using Policy = decltype(policy);
        if (Policy::fits(field)) draw<Policy>(field, camera, surface);
    };

    constexpr OcclusionUse kRead = OcclusionUse::read;
    draw_as(GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, MeanRgb565, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, NearestTap, GuidedIndex4, MeanPalette8, kRead>());
    draw_as(GuidedPolicy<OneOrigin, LinearTaps, GuidedIndex8, MeanRgb565, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex8, MeanPalette8, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, LinearTaps, GuidedIndex4, NoMean, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, NearestTap, GuidedIndex8, NoMean, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, LinearTaps, GuidedVq8, MeanRgb565, kRead>());
    draw_as(GuidedPolicy<OneOrigin, NearestTap, GuidedVq8, MeanPalette8, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, NearestTap, NoChart, MeanRgb565, kRead>());
    draw_as(GuidedPolicy<ThreeOrigins, NearestTap, NoChart, MeanPalette8, kRead>());
}

View close_view()
{
    return {"close", look_at({0.9, -0.7, 0.5}, {0, 0, 0}, 33), {kSide, kSide, degrees(80)}};
}

}  // namespace

TEST_CASE("any rectangle of a guided picture shows the same bits", "[guided]")
{
    const OpenedGuided opened(focus_field(200, 200, 4000));
    for (const View& view : extreme_views(kSide)) {
        if (!view.visible) continue;
        INFO(view.name);
        const Camera camera = camera_of(view);
        FocusSurface surface(opened.field, camera);
        const std::vector<uint8_t> whole = draw<Linear3>(opened.field, camera, surface);
        std::minstd_rand random(3);
        bool same = true;
        for (int n = 0; n < 12; ++n) {
            const auto below = [&](int32_t limit) {
                return static_cast<int32_t>(random() % static_cast<uint32_t>(limit));
            };
            const int32_t x = below(camera.width_px()), y = below(camera.height_px());
            const int32_t width = 1 + below(camera.width_px() - x), height = 1 + below(camera.height_px() - y);
            std::vector<uint8_t> part(static_cast<size_t>(width * height) * 3);
            const Stripe stripe = {part.data(), x, y, width, height, static_cast<uint32_t>(width) * 3};
            REQUIRE(render_guided<Linear3, PixelRgb888>(opened.field, camera, surface, OverColour{kBehind}, stripe) ==
                    GuidedError::none);
            for (int32_t row = 0; row < height; ++row) {
                const auto from = part.begin() + row * width * 3;
                same =
                    same && std::equal(from, from + width * 3, whole.begin() + ((y + row) * camera.width_px() + x) * 3);
            }
        }
        CHECK(same);
    }
}

TEST_CASE("a guided pixel beside the surface is background", "[guided]")
{
    const OpenedGuided opened(guided_file(GuidedTexel::index4, MeanFormat::rgb565));
    const Camera camera = camera_of(close_view());
    auto nothing = seeing<1>([](int32_t, int32_t, SurfacePoint(&)[1]) { return 0u; });
    size_t k = 0;
    for (const uint8_t v : draw<Best>(opened.field, camera, nothing)) {
        REQUIRE(v == (k % 3 == 0 ? kBehind.r : k % 3 == 1 ? kBehind.g : kBehind.b));
        ++k;
    }
    std::vector<uint8_t> kept(static_cast<size_t>(kSide * kSide) * 3, 77);
    const Stripe stripe = {kept.data(), 0, 0, kSide, kSide, static_cast<uint32_t>(kSide) * 3};
    REQUIRE(render_guided<Best, PixelRgb888>(opened.field, camera, nothing, OverStripe{}, stripe) == GuidedError::none);
    CHECK(std::all_of(kept.begin(), kept.end(), [](uint8_t v) { return v == 77; }));
}

TEST_CASE("surfaces that share a pixel mix as light, and show the background by what they leave", "[guided]")
{
    const OpenedGuided opened(guided_file(GuidedTexel::index4, MeanFormat::rgb565));
    const Camera camera = camera_of(close_view());
    const SurfacePoint a = {3000, 2000, 4000, 1}, b = {-2000, 3000, -1000, 2};
    const auto shade_of = [&](const SurfacePoint& p) {
        auto alone = seeing<1>([&](int32_t, int32_t, SurfacePoint(&out)[1]) {
            out[0] = {p.x_q14, p.y_q14, p.z_q14, 1};
            return 1u;
        });
        return draw<Best>(opened.field, camera, alone);
    };
    const std::vector<uint8_t> only_a = shade_of(a), only_b = shade_of(b);
    auto both = seeing<4>([&](int32_t, int32_t, SurfacePoint(&out)[4]) {
        out[0] = a;
        out[1] = b;
        return 2u;
    });
    const std::vector<uint8_t> mixed = draw<Best>(opened.field, camera, both);
    auto part = seeing<4>([&](int32_t, int32_t, SurfacePoint(&out)[4]) {
        out[0] = {a.x_q14, a.y_q14, a.z_q14, 3};
        return 1u;
    });
    const std::vector<uint8_t> partly = draw<Best>(opened.field, camera, part);
    const uint8_t under[3] = {kBehind.r, kBehind.g, kBehind.b};
    Worst worst;
    const int32_t y = kSide / 2;
    const RowSpan covered = covered_span(camera, y, 0, kSide);
    REQUIRE(covered.end - covered.begin > kSide / 2);
    for (int32_t k = (y * kSide + covered.begin) * 3; k < (y * kSide + covered.end) * 3; ++k) {
        const size_t at = static_cast<size_t>(k);
        const double mean = (light_of_level(only_a[at]) + 2 * light_of_level(only_b[at])) / 3;
        const double level = level_of_light(mean);
        worst.see(std::fabs(mixed[at] - (0.75 * level + 0.25 * under[at % 3])), at);
        worst.see(std::fabs(partly[at] - (0.75 * only_a[at] + 0.25 * under[at % 3])), at);
    }
    worst.report("mixture of surfaces, levels");
    CHECK(worst.error < 1.01);
}

TEST_CASE("drawing refuses fields that a policy cannot read, and odd addresses", "[guided]")
{
    const Bytes bytes = guided_file(GuidedTexel::index4, MeanFormat::rgb565);
    const Camera camera = camera_of(close_view());
    auto nothing = seeing<1>([](int32_t, int32_t, SurfacePoint(&)[1]) { return 0u; });
    uint8_t pixel[3] = {};
    const Stripe stripe = {pixel, 0, 0, 1, 1, 3};
    const auto drawn = [&](const GuidedField& field, auto policy) {
        return render_guided<decltype(policy), PixelRgb888>(field, camera, nothing, OverBlack{}, stripe);
    };
    const OpenedGuided opened(bytes);
    CHECK(drawn(opened.field, Best()) == GuidedError::none);
    CHECK(drawn(opened.field, Linear3()) == GuidedError::wrong_policy);
    std::vector<uint8_t> shifted(bytes.size() + 2);
    std::copy(bytes.begin(), bytes.end(), shifted.begin() + 2);
    GuidedField odd;
    REQUIRE(open_guided(shifted.data() + 2, bytes.size(), odd) == FieldError::none);
    CHECK(drawn(odd, Best()) == GuidedError::unaligned);
    CHECK(std::string(describe(GuidedError::unaligned)) != describe(GuidedError::wrong_policy));
}

TEST_CASE("a picture of blocks has the same bits on every machine", "[guided]")
{
    const OpenedGuided opened(guided_file(GuidedTexel::vq8, MeanFormat::palette8));
    const View view = {"close", look_at({0.9, -0.7, 0.5}, {0, 0, 0}, 33), {20, 20, degrees(80)}};
    const Camera camera = camera_of(view);
    auto surface = seeing<4>(scattered);
    const auto crc_as = [&](auto policy) {
        const std::vector<uint8_t> pixels = draw<decltype(policy)>(opened.field, camera, surface);
        return crc32(0, pixels.data(), pixels.size());
    };
    constexpr OcclusionUse kRead = OcclusionUse::read;
    CHECK(crc_as(GuidedPolicy<ThreeOrigins, LinearTaps, GuidedVq8, MeanPalette8, kRead>()) == 0xE4DCE109u);
    CHECK(crc_as(GuidedPolicy<ThreeOrigins, NearestTap, GuidedVq8, MeanPalette8, kRead>()) == 0x62B27886u);
    CHECK(crc_as(GuidedPolicy<OneOrigin, NearestTap, GuidedVq8, MeanPalette8, kRead>()) == 0x403C2944u);
}

TEST_CASE("hostile rows, directories and colours are read within the file", "[guided]")
{
    const GuidedTexel texel = GENERATE(GuidedTexel::index4, GuidedTexel::index8, GuidedTexel::vq8);
    const MeanFormat mean = GENERATE(MeanFormat::rgb565, MeanFormat::palette8);
    Bytes bytes = guided_file(texel, mean);
    GuidedField layout;
    REQUIRE(open_guided(bytes.data(), bytes.size(), layout) == FieldError::none);
    const auto offset = [&](const uint8_t* p) { return static_cast<size_t>(p - bytes.data()); };
    const size_t rows = offset(layout.chart.rows), coarse_rows = offset(layout.occlusion.rows);
    const size_t directory = offset(layout.chart.directory);
    const uint32_t texels = layout.chart.texel_count;
    std::minstd_rand random(static_cast<uint32_t>(texel) * 2 + static_cast<uint32_t>(mean));
    const Camera camera = camera_of(close_view());
    for (int n = 0; n < 12; ++n) {
        // Rows may hold anything: their section's CRC is checked by verify_field alone.
        for (uint32_t k = 0; k < 2 * layout.chart.row_count; ++k) bytes[rows + k] = static_cast<uint8_t>(random());
        for (uint32_t k = 0; k < 2 * layout.occlusion.row_count; ++k)
            bytes[coarse_rows + k] = static_cast<uint8_t>(random());
        // Texels may begin anywhere up to the last one, first rows lie anywhere.
        for (uint32_t i = 0; i < layout.used_origins; ++i) {
            uint8_t* entry = &bytes[directory + i * format::chart::kEntryBytes];
            const uint32_t base = n % 3 == 0 ? texels : static_cast<uint32_t>(random() % (texels + 1));
            for (int b = 0; b < 4; ++b) entry[b] = static_cast<uint8_t>(base >> 8 * b);
            entry[format::chart::kFirstRowAt] = static_cast<uint8_t>(random());
            entry[format::chart::kFirstRowAt + 1] = static_cast<uint8_t>(n % 2 == 0 ? 0 : random());
        }
        const OpenedGuided opened(bytes);
        draw_every_way(opened.field, camera);
    }
}

TEST_CASE("every policy draws points anywhere, from anywhere", "[guided]")
{
    for (const GuidedTexel texel : {GuidedTexel::none, GuidedTexel::index4, GuidedTexel::index8, GuidedTexel::vq8}) {
        for (const MeanFormat mean : {MeanFormat::rgb565, MeanFormat::palette8}) {
            const OpenedGuided opened(guided_file(texel, mean));
            for (const View& view : extreme_views(kSide / 2)) draw_every_way(opened.field, camera_of(view));
        }
    }
    const OpenedGuided bare(focus_field(64, 64, 0));
    for (const View& view : extreme_views(kSide / 2)) draw_every_way(bare.field, camera_of(view));
}
