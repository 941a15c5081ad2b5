// SPDX-License-Identifier: MIT
#include "lumi/chord/render.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "field_bytes.h"
#include "lumi/twin/picture.h"
#include "report.h"
#include "twin.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;
using twin::Colour;
using twin::decoded;
using twin::Hits;
using twin::Weights;

namespace
{

// `nudge` is how far rounding may move a hit in effect: for nearest, by the stated tolerance of the inverse map.
struct NearestTwin {
    using Device = Nearest;
    static constexpr const char* kName = "nearest";
    static double nudge(size_t n) { return twin::spacing(static_cast<uint32_t>(n)) / 512; }
    static Weights weights(const std::vector<Vec3>& all, const Vec3& q) { return twin::nearest_weights(all, q); }
};

struct LinearTwin {
    using Device = Linear;
    static constexpr const char* kName = "linear";
    static double nudge(size_t) { return 2e-6; }
    static Weights weights(const std::vector<Vec3>& all, const Vec3& q) { return twin::linear_weights(all, q); }
};

template <uint32_t K>
struct PaperTwin {
    using Device = Paper<K>;
    static constexpr const char* kName = "paper";
    static double nudge(size_t) { return 2e-6; }
    static Weights weights(const std::vector<Vec3>& all, const Vec3& q) { return twin::paper_weights(all, q, K); }
};

// ---- The renderer in double precision. ----

struct Scene {
    Bytes bytes;
    Field field;
    std::vector<Vec3> origins, directions;

    explicit Scene(const TestLayout& layout)
        : bytes(make(layout)), origins(twin::points(layout.origins)), directions(twin::points(layout.directions))
    {
        REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    }

    // A colourful pattern over the sphere with a hole: rays that point up steeply miss.
    static Bytes make(const TestLayout& layout)
    {
        const auto texel = [&](uint32_t i, uint32_t k) {
            const Vec3 o = twin::point(layout.origins, i);
            const Vec3 d = twin::point(layout.directions, std::min(k / 3, layout.directions - 1));
            if (d.z > 0.8) return uint8_t{0};
            const double channel[3] = {0.5 + 0.5 * d.x * o.y, 0.5 + 0.5 * d.y, 0.5 + 0.5 * d.z * o.x};
            return static_cast<uint8_t>(1 + 254 * channel[k % 3]);
        };
        return file_of({layout_section(layout), texel_section(layout, texel)});
    }
};

const Rgb8 kBackground = {30, 200, 90};

double difference(const Colour& a, const uint8_t* b)
{
    return std::max({std::fabs(a.r - b[0]), std::fabs(a.g - b[1]), std::fabs(a.b - b[2])});
}

// Hits moved by a little within the tangent plane: what rounding may do to them. Index 0 is the unmoved pair.
Hits nudged(const Hits& hit, int direction, double front_by, double back_by)
{
    if (direction == 0) return hit;
    const double angle = direction * twin::kPi / 4;
    const auto nudge = [&](const Vec3& h, double by) {
        const Vec3 side = twin::normalised(test::cross(h, std::fabs(h.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
        const Vec3 other = test::cross(h, side);
        return h + (by * std::cos(angle)) * side + (by * std::sin(angle)) * other;
    };
    return {nudge(hit.front, front_by), nudge(hit.back, back_by)};
}

// A pixel lies on a border of the reconstruction if nudging its hits changes the twin by more than rounding.
template <class Twin>
double pixel_error(const Scene& scene, const Hits& hit, const uint8_t* drawn)
{
    double best = 1e9;
    for (int nudge = 0; nudge <= 8 && best > 1.5; ++nudge) {
        const Hits moved = nudged(hit, nudge, Twin::nudge(scene.origins.size()), Twin::nudge(scene.directions.size()));
        const Colour truth = twin::blended(scene.field, Twin::weights(scene.origins, moved.front),
                                           Twin::weights(scene.directions, moved.back), kBackground);
        best = std::min(best, difference(truth, drawn));
    }
    return best;
}

struct Errors {
    double sum = 0;
    uint32_t pixels = 0;
    Worst worst;
};

template <class Twin>
Errors compare(const Scene& scene, const View& view)
{
    Camera camera;
    REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
    const uint32_t width = static_cast<uint32_t>(view.image.width_px);
    const uint32_t height = static_cast<uint32_t>(view.image.height_px);
    std::vector<uint8_t> drawn(width * height * 3);
    const Stripe stripe = {drawn.data(), 0, 0, view.image.width_px, view.image.height_px, width * 3};
    REQUIRE(render<typename Twin::Device, TexelRgb888, PixelRgb888>(scene.field, camera, OverColour{kBackground},
                                                                    stripe) == RenderError::none);
    Errors errors;
    for (uint32_t k = 0; k < width * height; ++k) {
        SphereRay ray;
        const uint8_t* pixel = &drawn[3 * k];
        if (!ray_at(camera, static_cast<int32_t>(k % width), static_cast<int32_t>(k / width), ray)) {
            REQUIRE((pixel[0] == kBackground.r && pixel[1] == kBackground.g && pixel[2] == kBackground.b));
            continue;
        }
        const SphereHits hit = hits(camera, ray);
        const double e = pixel_error<Twin>(scene, {decoded(hit.front), decoded(hit.back)}, pixel);
        errors.sum += e;
        errors.pixels += 1;
        errors.worst.see(e, k);
    }
    return errors;
}

// Origins and directions of the smallest lattices, each against each; the light form keeps every number on both sides.
#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSide = 7, kCapSide = 9;
const std::vector<std::pair<uint32_t, uint32_t>> kSmallLattices = {{1, 1}, {1, 200}, {2, 3}, {3, 2}, {200, 1}};
#else
constexpr int32_t kSide = 33, kCapSide = 15;
const std::vector<std::pair<uint32_t, uint32_t>> kSmallLattices = {
    {1, 1}, {1, 2}, {1, 3}, {1, 200}, {2, 1},   {2, 2},   {2, 3},   {2, 200},
    {3, 1}, {3, 2}, {3, 3}, {3, 200}, {200, 1}, {200, 2}, {200, 3}, {200, 200}};
#endif

template <class Twin>
void check_against_twin()
{
    const Scene scene(layout_of(150, 260, TexelFormat::rgb888));
    for (const View& view : extreme_views(kSide)) {
        const Errors errors = compare<Twin>(scene, view);
        errors.worst.report((std::string(Twin::kName) + ", " + view.name + ", levels; mean " +
                             std::to_string(errors.pixels != 0 ? errors.sum / errors.pixels : 0))
                                .c_str());
        INFO(view.name);
        CHECK(errors.worst.error < 3.0);
        CHECK(errors.sum <= 0.75 * errors.pixels);
    }
}

}  // namespace

TEST_CASE("nearest agrees with the double-precision renderer at every extreme", "[render]")
{
    check_against_twin<NearestTwin>();
}

TEST_CASE("linear agrees with the double-precision renderer at every extreme", "[render]")
{
    check_against_twin<LinearTwin>();
}

TEST_CASE("the paper's kernel agrees with the double-precision renderer at every extreme", "[render]")
{
    check_against_twin<PaperTwin<5>>();
}

TEST_CASE("lattices of 1, 2 and 3 points are drawn like the twin", "[render]")
{
    for (const auto& [origins, directions] : kSmallLattices) {
        const Scene scene(layout_of(origins, directions, TexelFormat::rgb888));
        for (const View& view : extreme_views(7)) {
            INFO(view.name << " M " << origins << " N " << directions);
            CHECK(compare<NearestTwin>(scene, view).worst.error < 3.0);
            CHECK(compare<LinearTwin>(scene, view).worst.error < 3.0);
            CHECK(compare<PaperTwin<9>>(scene, view).worst.error < 3.0);
        }
    }
}

TEST_CASE("origins outside the cap are transparent", "[render]")
{
    const Scene scene(layout_of(100, 120, TexelFormat::rgb888, 50));
    for (const View& view : extreme_views(kCapSide)) {
        INFO(view.name);
        CHECK(compare<LinearTwin>(scene, view).worst.error < 3.0);
    }
}

TEST_CASE("over the stripe's own content only the object is drawn", "[render]")
{
    const Scene scene(layout_of(70, 70, TexelFormat::rgb888));
    Camera camera;
    REQUIRE(make_camera(look_at({3, 1, 0.5}, {0, 0, 0}), {24, 24, degrees(60)}, camera) == CameraError::none);
    std::vector<uint8_t> over_colour(24 * 24 * 3);
    std::vector<uint8_t> over_stripe(24 * 24 * 3);
    for (size_t k = 0; k < over_stripe.size(); k += 3) PixelRgb888::store(&over_stripe[k], kBackground);
    const Stripe a = {over_colour.data(), 0, 0, 24, 24, 72};
    const Stripe b = {over_stripe.data(), 0, 0, 24, 24, 72};
    REQUIRE(render<Linear, TexelRgb888, PixelRgb888>(scene.field, camera, OverColour{kBackground}, a) ==
            RenderError::none);
    REQUIRE(render<Linear, TexelRgb888, PixelRgb888>(scene.field, camera, OverStripe{}, b) == RenderError::none);
    CHECK(over_colour == over_stripe);
}

TEST_CASE("saturated colours blend without overflow", "[render]")
{
    // All-white and all-saturated palettes with partial coverage over a white background: the sums' upper end.
    TestLayout layout;
    layout.texel = TexelFormat::palette8;
    TestSection palette = palette_section();
    for (uint32_t k = 0; k < 256; ++k)
        for (uint32_t c = 0; c < 4; ++c) palette.bytes[4 * k + c] = static_cast<uint8_t>(k);
    const Bytes bytes = file_of(
        {layout_section(layout),
         texel_section(layout, [](uint32_t i, uint32_t k) { return static_cast<uint8_t>(255 - i * 7 - k); }), palette});
    Field field;
    REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    Camera camera;
    REQUIRE(make_camera(look_at({2, 0.5, 0.3}, {0, 0, 0}), {20, 20, degrees(50)}, camera) == CameraError::none);
    std::vector<uint8_t> pixels(20 * 20);
    const Stripe stripe = {pixels.data(), 0, 0, 20, 20, 20};
    REQUIRE(render<Paper<9>, TexelPalette8, PixelGrey8>(field, camera, OverColour{{255, 255, 255}}, stripe) ==
            RenderError::none);
    for (const uint8_t p : pixels) REQUIRE(p >= 254);
}
