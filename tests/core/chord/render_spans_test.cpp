// SPDX-License-Identifier: MIT
#include "lumi/chord/render_spans.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "chord/drawing.h"
#include "report.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSide = 24;
constexpr uint32_t kRandomViews = 3;
#else
constexpr int32_t kSide = 96;
constexpr uint32_t kRandomViews = 200;
#endif

// Channel c of a smooth function of a ray's ends, 1 .. 255.
uint8_t shade(const Vec3& from, const Vec3& to, uint32_t c)
{
    const double channel[3] = {0.5 + 0.25 * std::sin(3 * to.x + from.y) + 0.2 * to.z,
                               0.5 + 0.4 * std::sin(2 * to.y - 2 * from.z), 0.5 + 0.4 * std::cos(3 * to.z * from.x)};
    return static_cast<uint8_t>(1 + 254 * std::clamp(channel[c], 0.0, 1.0));
}

// A field of it, so that a picture tells how far its taps are off.
Bytes smooth_field(uint32_t origins, uint32_t used, uint32_t directions, TexelFormat texel)
{
    const TestLayout layout = layout_of(origins, directions, texel, used);
    const uint32_t bytes = format::bytes_per_texel(texel);
    const std::vector<Vec3> o = twin::points(origins);
    const std::vector<Vec3> d = twin::points(directions);
    const auto value = [&](uint32_t i, uint32_t k) {
        const Vec3& from = o[i];
        const Vec3& to = d[std::min(k / bytes, directions - 1)];
        if (texel != TexelFormat::rgb565) return shade(from, to, k % bytes);
        const uint16_t v = TexelRgb565::encode({shade(from, to, 0), shade(from, to, 1), shade(from, to, 2)});
        return static_cast<uint8_t>(k % 2 == 0 ? v : v >> 8);
    };
    std::vector<TestSection> sections = {layout_section(layout), texel_section(layout, value)};
    if (texel == TexelFormat::palette8) sections.push_back(palette_section());
    return file_of(sections);
}

// span_px = 0 draws exactly.
template <class Reconstruction, class Texel, class Background>
Bytes draw(const Field& field, const View& view, const Background& background, int32_t span_px)
{
    return drawn_frame<Reconstruction, Texel, PixelRgb888>(field, camera_of(view), background, span_px, 77);
}

// A field that spans cannot draw: an error, and no pixel is touched.
template <class Texel>
void check_refused(const Field& field, const View& view)
{
    std::vector<uint8_t> pixels(static_cast<size_t>(view.image.width_px * view.image.height_px), 77);
    const Stripe stripe = {
        pixels.data(), 0, 0, view.image.width_px, view.image.height_px, static_cast<uint32_t>(view.image.width_px)};
    CHECK(render_spans<Linear, Texel, PixelGrey8>(field, camera_of(view), OverBlack{}, stripe, 8) ==
          RenderError::unfit_for_spans);
    CHECK(std::count(pixels.begin(), pixels.end(), 77) == static_cast<ptrdiff_t>(pixels.size()));
}

struct Difference {
    double mean_square = 0;
    Worst worst;
    double psnr_db() const { return 10 * std::log10(255 * 255 / std::max(mean_square, 1e-9)); }
};

Difference difference(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b)
{
    Difference result;
    for (size_t k = 0; k < a.size(); ++k) {
        const double d = std::fabs(static_cast<double>(a[k]) - b[k]);
        result.mean_square += d * d / static_cast<double>(a.size());
        result.worst.see(d, k / 3);
    }
    return result;
}

}  // namespace

TEST_CASE("spans draw the exact linear picture at every extreme", "[span]")
{
    const OpenField open(smooth_field(300, 300, 700, TexelFormat::rgb888));
    const Field& field = open.field;
    const int32_t span_px = GENERATE(2, 4, 8, 16);
    for (const View& view : extreme_views(kSide)) {
        const auto exact = draw<Linear, TexelRgb888>(field, view, OverColour{{20, 20, 20}}, 0);
        const Difference d =
            difference(exact, draw<Linear, TexelRgb888>(field, view, OverColour{{20, 20, 20}}, span_px));
        d.worst.report(
            (view.name + ", spans of " + std::to_string(span_px) + ", " + std::to_string(d.psnr_db()) + " dB, levels")
                .c_str());
        INFO(view.name << " " << span_px);
        CHECK(d.psnr_db() > 38);
    }
}

TEST_CASE("cells that cross the equator keep the diagonals of the exact renderer", "[span]")
{
    // 400 and 1024 points are acute at their equator, 300 and 700 obtuse.
    const Vec3 eye = {2.3, 1.4, 0.1};
    const View view = {"equator", look_at(eye, {0, 0, 0}, 10), {kSide, kSide, degrees(40)}};
#ifdef LUMI_TEST_LIGHT
    const std::vector<uint32_t> sizes = {300, 400};  // larger ones would not fit into a board's memory
#else
    const std::vector<uint32_t> sizes = {300, 400, 700, 1024};
#endif
    for (const uint32_t n : sizes) {
        const OpenField open(smooth_field(n, n, n, TexelFormat::luma8));
        const Field& field = open.field;
        const auto exact = draw<Linear, TexelLuma8>(field, view, OverBlack{}, 0);
        INFO(n);
        CHECK(difference(exact, draw<Linear, TexelLuma8>(field, view, OverBlack{}, 2)).psnr_db() > 52);
    }
}

TEST_CASE("shorter spans come closer to the exact picture", "[span]")
{
    const OpenField open(smooth_field(300, 300, 700, TexelFormat::rgb888));
    const Field& field = open.field;
    double before = 0;
    for (const int32_t span_px : {16, 8, 4, 2}) {
        double sum = 0;
        std::minstd_rand random(7);
        for (uint32_t k = 0; k < std::max<uint32_t>(3, kRandomViews / 10); ++k) {
            const View view = random_view(random, kSide);
            const auto exact = draw<Linear, TexelRgb888>(field, view, OverBlack{}, 0);
            sum += difference(exact, draw<Linear, TexelRgb888>(field, view, OverBlack{}, span_px)).psnr_db();
        }
        CHECK(sum >= before);
        before = sum;
    }
}

TEST_CASE("spans of 8 hold for hundreds of random views", "[span]")
{
    const OpenField open(smooth_field(300, 300, 700, TexelFormat::rgb888));
    const Field& field = open.field;
    std::minstd_rand random(11);
    Worst linear;
    for (uint32_t k = 0; k < kRandomViews; ++k) {
        const View view = random_view(random, kSide);
        const OverBlack black;
        linear.see(-difference(draw<Linear, TexelRgb888>(field, view, black, 0),
                               draw<Linear, TexelRgb888>(field, view, black, 8))
                           .psnr_db() +
                       100,
                   k);
    }
    std::printf("spans of 8 over %u random views, lowest PSNR: linear %.1f dB at %u\n",
                static_cast<unsigned>(kRandomViews), 100 - linear.error, static_cast<unsigned>(linear.where));
    CHECK(100 - linear.error > 45);
}

TEST_CASE("a field of another texel format is refused by every renderer, and no pixel is touched")
{
    const OpenField open(smooth_field(300, 300, 700, TexelFormat::luma8));
    const Field& field = open.field;
    const Camera camera = camera_of(extreme_views(16)[0]);
    std::vector<uint8_t> pixels(16 * 16, 77);
    const Stripe stripe = {pixels.data(), 0, 0, 16, 16, 16};
    CHECK(render_spans<Linear, TexelPalette8, PixelGrey8>(field, camera, OverBlack{}, stripe, 8) ==
          RenderError::wrong_texel_format);
    CHECK(render<Linear, TexelPalette8, PixelGrey8>(field, camera, OverBlack{}, stripe) ==
          RenderError::wrong_texel_format);
    CHECK(std::count(pixels.begin(), pixels.end(), 77) == static_cast<ptrdiff_t>(pixels.size()));
}

namespace
{

// Some texels are misses: those of rays that go up. Seen from below that is a third of the picture.
template <class Texel>
Bytes field_with_a_hole()
{
    const TestLayout layout = layout_of(300, 700, Texel::kFormat);
    const uint32_t bytes = format::bytes_per_texel(layout.texel);
    const std::vector<Vec3> d = twin::points(layout.directions);
    const auto value = [&](uint32_t, uint32_t k) {
        return static_cast<uint8_t>(d[std::min(k / bytes, layout.directions - 1)].z > 0.4 ? 0 : 200);
    };
    std::vector<TestSection> sections = {layout_section(layout), texel_section(layout, value)};
    if (layout.texel == TexelFormat::palette8) {
        sections.push_back(palette_section());
        std::fill_n(sections.back().bytes.begin(), 4, uint8_t{0});
    }
    return file_of(sections);
}

const Rgb8 kGreen = {10, 240, 20};

// How many more or fewer pixels show the background alone, and how alike the pictures are at least.
struct Alike {
    int pixels;
    double psnr_db;
};

template <class Texel, class Reconstruction>
void check_hole(const Alike& alike)
{
    const OpenField open(field_with_a_hole<Texel>());
    const Field& field = open.field;
    for (const double up : {-0.8, 0.3, 0.9}) {  // from below, the side and above
        const View view = {"hole", look_at({1.8, 1.1, 2 * up}, {0, 0, 0}, 10), {kSide, kSide, degrees(50)}};
        const auto exact = draw<Reconstruction, Texel>(field, view, OverColour{kGreen}, 0);
        const auto spans = draw<Reconstruction, Texel>(field, view, OverColour{kGreen}, 2);
        const auto greens = [&](const std::vector<uint8_t>& pixels) {
            int count = 0;
            for (size_t k = 0; k < pixels.size(); k += 3)
                count += pixels[k] == kGreen.r && pixels[k + 1] == kGreen.g && pixels[k + 2] == kGreen.b ? 1 : 0;
            return count;
        };
        INFO(Texel::kName << ", from a height of " << 2 * up);
        CHECK(std::abs(greens(spans) - greens(exact)) <= alike.pixels);
        CHECK(difference(exact, spans).psnr_db() > alike.psnr_db);
    }
}

template <class Texel>
void check_holes()
{
    check_hole<Texel, Linear>({kSide / 4, 40});
    check_hole<Texel, Nearest>({kSide / 8, 27});  // its cells on spans are others
}

}  // namespace

TEST_CASE("through a hole of a field the background shows, in every texel format", "[span]")
{
    check_holes<TexelRgb888>();
    check_holes<TexelRgb565>();
    check_holes<TexelPalette8>();
    check_holes<TexelLuma8>();
}

TEST_CASE("over black and over a black colour spans draw the same", "[span]")
{
    const OpenField open(smooth_field(200, 200, 300, TexelFormat::rgb888));
    const Field& field = open.field;
    const View view = extreme_views(kSide)[0];
    const auto a = draw<Linear, TexelRgb888>(field, view, OverBlack{}, 8);
    CHECK(difference(a, draw<Linear, TexelRgb888>(field, view, OverColour{{0, 0, 0}}, 8)).worst.error <= 1);
}

TEST_CASE("origins that are not baked stay transparent on spans, and their bytes are never read", "[span]")
{
    // The texel section ends with the last used row: AddressSanitizer sees any read beyond.
    const Bytes bytes = smooth_field(400, 150, 300, TexelFormat::rgb888);
    const std::unique_ptr<uint8_t[]> copy(new uint8_t[bytes.size()]);
    std::copy(bytes.begin(), bytes.end(), copy.get());
    Field field;
    REQUIRE(open_field(copy.get(), bytes.size(), field) == FieldError::none);
    for (const View& view : extreme_views(kSide)) {
        const auto exact = draw<Linear, TexelRgb888>(field, view, OverColour{{20, 200, 20}}, 0);
        const Difference d = difference(exact, draw<Linear, TexelRgb888>(field, view, OverColour{{20, 200, 20}}, 8));
        INFO(view.name);
        CHECK(d.psnr_db() > 33);
        (void)draw<Nearest, TexelRgb888>(field, view, OverBlack{}, 16);
    }
}

TEST_CASE("lattices of every size are drawn, the small and the huge ones are refused", "[span]")
{
    const View view = extreme_views(kSide / 2)[0];
    const uint32_t sizes[] = {1, 2, 63, 64, 65, 89, 144, 1000, 10000};
    for (const uint32_t n : sizes) {
        const OpenField open(smooth_field(n, std::min<uint32_t>(n, 100), 70, TexelFormat::luma8));
        const Field& field = open.field;
        INFO(n);
        REQUIRE(fits_spans(field) == (n >= kMinSpanLattice));
        if (fits_spans(field)) {
            const auto exact = draw<Linear, TexelLuma8>(field, view, OverBlack{}, 0);
            const auto spans = draw<Linear, TexelLuma8>(field, view, OverBlack{}, 8);
            CHECK(difference(exact, spans).psnr_db() > 33);
        } else {
            check_refused<TexelLuma8>(field, view);
        }
    }
    Field huge;
    huge.origins = Lattice(kMaxSpanLattice + 1);
    huge.directions = Lattice(64);
    CHECK(!fits_spans(huge));
}

TEST_CASE("unaligned fields are refused", "[span]")
{
    const Bytes bytes = smooth_field(100, 100, 100, TexelFormat::rgb565);
    std::vector<uint8_t> shifted(bytes.size() + 9);
    uint8_t* odd = shifted.data() + (reinterpret_cast<uintptr_t>(shifted.data()) % 2 == 0 ? 1 : 0);
    std::copy(bytes.begin(), bytes.end(), odd);
    Field field;
    REQUIRE(open_field(odd, bytes.size(), field) == FieldError::none);
    CHECK(!fits_spans(field));
    check_refused<TexelRgb565>(field, extreme_views(20)[0]);
}
