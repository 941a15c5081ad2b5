// SPDX-License-Identifier: MIT
// Random frames at the ends of what cameras, stripes and fields may be: a million of each layout under
// AddressSanitizer and UndefinedBehaviorSanitizer by `tools/test.sh --all`, a sample of them elsewhere. No intermediate
// overflows, nothing beside a stripe is touched, and no pixel depends on what memory held before.
#include <catch2/catch.hpp>
#include <climits>
#include <memory>

#include "edges.h"
#include "field_bytes.h"
#include "lumi/render_spans_paper.h"
#include "lumi/render_surface.h"
#include "surface/surface_bytes.h"
#include "surface/surface_drawing.h"

using namespace lumi;
using namespace lumi::test;
using format::TexelFormat;

namespace
{

#if defined(LUMI_EXTREME_FRAMES)
constexpr uint32_t kFrames = LUMI_EXTREME_FRAMES;
#elif defined(LUMI_TEST_LIGHT)
constexpr uint32_t kFrames = 500;
#else
constexpr uint32_t kFrames = 5000;
#endif
constexpr int32_t kWindowPx = 15;       // frames of at most 31 × 15 pixels
constexpr uint32_t kDrawnTwice = 8;     // every eighth frame is drawn again over other memory
constexpr uint32_t kDrawnExactly = 64;  // `render` takes a hundred times as long

// A frame, and the stripe of it that is drawn.
struct Extreme {
    Edge edge;
    uint32_t choice;  // any number: of what the test draws
};

class Extremes
{
public:
    explicit Extremes(uint32_t seed) : edges_(seed, kWindowPx) {}

    Extreme next()
    {
        const double fovs[] = {1, 2, 45, 120, edges_.uniform(1, 120)};
        Extreme e{edges_.next(distance(), fovs[below(5)]), below(1u << 24)};
        if (below(8) == 0) e.edge.x += static_cast<int32_t>(below(80)) - 40;
        if (below(8) == 0) e.edge.y += static_cast<int32_t>(below(80)) - 40;
        const int32_t ends[] = {INT_MIN, -32769, 16384, 32767, INT_MAX - 64};  // nothing lies beyond INT_MAX
        if (below(64) == 0) e.edge.x = ends[below(5)];
        if (below(64) == 0) e.edge.y = ends[below(5)];
        return e;
    }

    uint32_t below(uint32_t count) { return static_cast<uint32_t>(edges_.uniform(0, count)); }

private:
    // On the sphere, just above it, and as far away as eyes go.
    double distance()
    {
        const double ends[] = {1, 1.0001, 1.01, 2046.99};
        const uint32_t k = below(8);
        return k < 4 ? ends[k] : std::pow(2.0, edges_.uniform(0.001, 10.9));
    }

    Edges edges_;
};

// Pixels in memory of their very size.
struct Canvas {
    Canvas(const Edge& edge, uint32_t pixel_bytes, uint8_t held)
        : stride(static_cast<uint32_t>(edge.width) * pixel_bytes),
          pixels(stride * static_cast<size_t>(edge.height), held)
    {
        stripe = {pixels.data(), edge.x, edge.y, edge.width, edge.height, stride};
    }

    uint32_t stride;
    Bytes pixels;
    Stripe stripe{};
};

// draw(canvas, held) into fresh memory that holds `held`; now and then again over other memory. How many bytes show
// something.
template <class Draw>
uint64_t draw_frame(const Edge& edge, uint32_t pixel_bytes, bool twice, const Draw& draw)
{
    Canvas canvas(edge, pixel_bytes, 0x00);
    draw(canvas.stripe, uint8_t{0x00});
    if (twice) {
        Canvas again(edge, pixel_bytes, 0xFF);
        draw(again.stripe, uint8_t{0xFF});
        REQUIRE((canvas.pixels == again.pixels));
    }
    return static_cast<uint64_t>(
        std::count_if(canvas.pixels.begin(), canvas.pixels.end(), [](uint8_t byte) { return byte != 0; }));
}

template <class Reconstruction, class Texel>
void draw_chord(const Field& field, const Camera& camera, const Stripe& stripe, uint32_t choice)
{
    const bool exactly = choice % kDrawnExactly == 0;
    const RenderError error = exactly ? render<Reconstruction, Texel, PixelRgb565>(field, camera, OverBlack{}, stripe)
                                      : render_spans<Reconstruction, Texel, PixelRgb565>(
                                            field, camera, OverBlack{}, stripe, 2 << (choice >> 6) % 4);
    REQUIRE(error == RenderError::none);
}

template <class Texel>
void draw_chord(const Field& field, const Camera& camera, const Stripe& stripe, uint32_t choice)
{
    switch ((choice >> 8) % 6) {
        case 0:
            return draw_chord<Nearest, Texel>(field, camera, stripe, choice);
        case 1:
            return draw_chord<Dither, Texel>(field, camera, stripe, choice);
        case 2:
            return draw_chord<NearestVoronoi, Texel>(field, camera, stripe, choice);
        case 3:
            return draw_chord<Paper<9>, Texel>(field, camera, stripe, choice);
        default:
            return draw_chord<Linear, Texel>(field, camera, stripe, choice);
    }
}

// From the smallest lattices that spans take to the largest, some with a cap.
std::vector<Bytes> chord_fields()
{
    struct Size {
        uint32_t origins, used, directions;
        TexelFormat texel;
    };
    const Size sizes[] = {{64, 64, 64, TexelFormat::rgb565},
                          {400, 210, 700, TexelFormat::palette8},
                          {1000, 1, 64, TexelFormat::rgb888},
#ifndef LUMI_TEST_LIGHT
                          {64, 64, kMaxSpanLattice, TexelFormat::luma8},
                          {kMaxSpanLattice, kMaxSpanLattice / 2, 64, TexelFormat::palette8},
#endif
                          {233, 233, 144, TexelFormat::luma8}};
    std::vector<Bytes> fields;
    for (const Size& size : sizes) {
        TestLayout layout;
        layout.origins = size.origins;
        layout.used_origins = size.used;
        layout.directions = size.directions;
        layout.texel = size.texel;
        fields.push_back(sample_field(layout));
    }
    return fields;
}

// Vertices anywhere in the sphere and where axes leave it; triangles between any three, slivers and points among them.
TestSurface wild_mesh(uint32_t seed)
{
    constexpr int32_t kRadius = 16384, kCorner = 9459;  // of the cube in the sphere
    const auto chance = [&](uint32_t count) { return scattered(seed = seed * 31 + 1) % count; };
    TestSurface s = bumpy_ball();
    for (SurfacePoint& v : s.vertices) {
        const uint32_t kind = chance(3);
        if (kind == 0) continue;
        for (int32_t& c : v) c = kind == 1 ? 0 : static_cast<int32_t>(chance(2 * kCorner + 1)) - kCorner;
        if (kind == 1) v[chance(3)] = chance(2) == 0 ? -kRadius : kRadius;
    }
    for (TestPatch& p : s.patches)
        if (chance(4) == 0) p.b = chance(static_cast<uint32_t>(s.vertices.size()));
    return s;
}

uint64_t draw_surface(const SurfaceField& field, const Extreme& e, bool twice)
{
    SurfaceCamera camera;
    REQUIRE(make_surface_camera(e.edge.pose, e.edge.image, camera) == CameraError::none);
    const SurfaceMode mode = kSurfaceModes[e.choice % 3];
    const uint32_t band_log2 = (e.choice >> 4) % 8;
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count));
    std::vector<uint16_t> bands(surface_bands(e.edge.image.height_px, band_log2));
    SurfaceFrame frame;
    prepare_surface<PixelRgb565>(field, camera, mode, {vertices.data(), links.data(), bands.data(), band_log2}, frame);
    return draw_frame(e.edge, PixelRgb565::kBytes, twice, [&](const Stripe& stripe, uint8_t held) {
        const uint32_t words = (surface_stripe_bytes(stripe.width_px, stripe.height_px, mode) + 3) / 4;
        std::vector<uint32_t> samples(words, held * 0x01010101u);
        render_surface<PixelRgb565>(frame, OverBlack{}, stripe, samples.data());
    });
}

}  // namespace

TEST_CASE("chord fields hold in random frames at every extreme")
{
    const std::vector<Bytes> files = chord_fields();
    std::vector<Field> fields(files.size());
    for (size_t k = 0; k < files.size(); ++k)
        REQUIRE(open_field(files[k].data(), files[k].size(), fields[k]) == FieldError::none);
    Extremes extremes(11);
    uint64_t shown = 0;
    for (uint32_t k = 0; k < kFrames; ++k) {
        const Extreme e = extremes.next();
        const Field& field = fields[extremes.below(static_cast<uint32_t>(fields.size()))];
        Camera camera;
        REQUIRE(make_camera(e.edge.pose, e.edge.image, camera) == CameraError::none);
        if (e.choice % 16 == 1) camera = interlaced_half(camera, static_cast<int32_t>(e.choice >> 5 & 1));
        shown += draw_frame(e.edge, PixelRgb565::kBytes, k % kDrawnTwice == 0, [&](const Stripe& stripe, uint8_t) {
            with_texel(field.texel_format,
                       [&](auto texel) { draw_chord<decltype(texel)>(field, camera, stripe, e.choice); });
        });
    }
    std::printf("%u extreme frames of chord fields, %llu bytes show something\n", static_cast<unsigned>(kFrames),
                static_cast<unsigned long long>(shown));
    CHECK(shown > 50 * uint64_t{kFrames});
}

TEST_CASE("surface fields hold in random frames at every extreme")
{
    std::vector<std::unique_ptr<OpenedSurface>> surfaces;
    surfaces.push_back(std::make_unique<OpenedSurface>(surface_file(bumpy_ball())));
    surfaces.push_back(std::make_unique<OpenedSurface>(surface_file(wavy_sheet())));
    for (uint32_t seed = 1; seed <= 6; ++seed)
        surfaces.push_back(std::make_unique<OpenedSurface>(surface_file(wild_mesh(seed))));
    for (const auto& surface : surfaces) REQUIRE(surface->error() == FieldError::none);
    Extremes extremes(12);
    uint64_t shown = 0;
    for (uint32_t k = 0; k < kFrames; ++k) {
        const Extreme e = extremes.next();
        const auto& surface = surfaces[extremes.below(static_cast<uint32_t>(surfaces.size()))];
        shown += draw_surface(surface->field(), e, k % kDrawnTwice == 0);
    }
    std::printf("%u extreme frames of surface fields, %llu bytes show something\n", static_cast<unsigned>(kFrames),
                static_cast<unsigned long long>(shown));
    CHECK(shown > 50 * uint64_t{kFrames});
}
