// SPDX-License-Identifier: MIT
// The renderer against double precision by other means: rays, triangle by triangle (twin/surface_picture.h).
#include <catch2/catch.hpp>
#include <cmath>

#include "lumi/twin/surface_picture.h"
#include "surface_bytes.h"
#include "surface_drawing.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr int32_t kSide = 48;
#ifdef LUMI_TEST_LIGHT
constexpr int32_t kExtremeSide = 20;
#else
constexpr int32_t kExtremeSide = kSide;
#endif
constexpr uint8_t kGain = 16;  // nodes then change colours by up to 32 levels, and no sum is clamped

struct Difference {
    double squares = 0, worst = 0;
    size_t pixels = 0;
    size_t missing = 0, added = 0;  // pixels covered in one picture, in no neighbour in the other

    double rms() const { return std::sqrt(squares / static_cast<double>(std::max<size_t>(1, 3 * pixels))); }
};

// Coverage of a pixel and the eight around it.
struct Around {
    double least = 1, most = 0;

    Around(const twin::SurfacePicture& p, int32_t x, int32_t y)
    {
        for (int32_t v = y - 1; v <= y + 1; ++v) {
            for (int32_t u = x - 1; u <= x + 1; ++u) {
                const bool inside = u >= 0 && v >= 0 && u < p.width_px && v < p.height_px;
                const double c = inside ? p.coverage[static_cast<size_t>(v * p.width_px + u)] : least;
                least = std::fmin(least, c);
                most = std::fmax(most, c);
            }
        }
    }
};

Difference difference(const Bytes& drawn, const twin::SurfacePicture& exact)
{
    Difference d;
    for (int32_t y = 0; y < exact.height_px; ++y) {
        for (int32_t x = 0; x < exact.width_px; ++x) {
            const size_t k = static_cast<size_t>(y * exact.width_px + x);
            const Around around(exact, x, y);
            const bool is_background = drawn[3 * k] == kSurfaceBackground.r &&
                                       drawn[3 * k + 1] == kSurfaceBackground.g &&
                                       drawn[3 * k + 2] == kSurfaceBackground.b;
            d.missing += is_background && around.least == 1 ? 1u : 0u;
            d.added += !is_background && around.most == 0 ? 1u : 0u;
            if (around.least < 1) continue;
            const double truth[3] = {exact.colours[k].r, exact.colours[k].g, exact.colours[k].b};
            for (size_t c = 0; c < 3; ++c) {
                const double error = std::fabs(truth[c] - drawn[3 * k + c]);
                d.squares += error * error;
                d.worst = std::fmax(d.worst, error);
            }
            ++d.pixels;
        }
    }
    return d;
}

Difference difference_of(const TestSurface& s, const View& view, SurfaceMode mode)
{
    std::vector<TestSection> sections = surface_sections(s);
    for (TestSection& section : sections) {
        if (section.type != format::kViewSection) continue;
        for (uint32_t v = 0; v < s.viewed; ++v) {
            const uint32_t record = format::view_colours_bytes(s.code_bits) + v * format::view_bytes(s.code_bits);
            for (uint32_t c = 0; c < format::kGainBytes; ++c)
                section.bytes[record + format::view_turn_at(s.code_bits) + format::kTurnBytes + c] = kGain;
        }
    }
    const OpenedSurface opened(file_of(sections));
    REQUIRE(opened.error() == FieldError::none);
    const Bytes picture = surface_picture(opened.field(), view, mode, {kMaxImageSide, 16});
    const twin::SurfaceDrawing drawing = {mode == SurfaceMode::two_by_two ? 2 : 1};
    return difference(picture,
                      twin::draw_surface(opened.bytes().data(), view.pose, view.image, drawing, kSurfaceBackground));
}

// Texels that rise slowly and in even steps, where the palette is smooth.
TestSurface smooth_ball()
{
    TestSurface s = bumpy_ball();
    s.viewed = 0;
    for (const TestPatch& p : s.patches)
        for (uint32_t k = 0; k < p.columns * p.rows; ++k)
            s.texels[p.begin + k] = static_cast<uint8_t>(60 + 4 * (k % p.columns) + 6 * (k / p.columns));
    return s;
}

}  // namespace

TEST_CASE("surfaces lie where rays meet them")
{
    const TestSurface s = bumpy_ball(), sheet = wavy_sheet();
    for (const View& view : extreme_views(kExtremeSide)) {
        for (const SurfaceMode mode : {SurfaceMode::one_sample, SurfaceMode::two_by_two}) {
            CAPTURE(view.name, static_cast<int>(mode));
            for (const TestSurface* surface : {&s, &sheet}) {
                const Difference d = difference_of(*surface, view, mode);
                CHECK(d.missing == 0);
                CHECK(d.added == 0);
            }
        }
    }
}

TEST_CASE("colours of surfaces are those of double precision")
{
    TestSurface s = smooth_ball();
    std::minstd_rand random(7);
    double squares = 0, pixels = 0;
    for (int k = 0; k < 12; ++k) {
        const View view = random_view(random, kSide);
        const Difference d = difference_of(s, view, k % 2 == 0 ? SurfaceMode::one_sample : SurfaceMode::two_by_two);
        squares += d.squares;
        pixels += 3 * static_cast<double>(d.pixels);
    }
    const double psnr_db = 10 * std::log10(255 * 255 * pixels / squares);
    CAPTURE(psnr_db);
    CHECK(psnr_db > 36);
}

TEST_CASE("view tables add what double precision adds, whatever the bits of their codes")
{
    TestSurface s = bumpy_ball();
    std::fill(s.texels.begin(), s.texels.end(), uint8_t{128});
    std::minstd_rand random(8);
    for (s.code_bits = 1; s.code_bits <= format::kMaxCodeBits; ++s.code_bits) {
        const View view = random_view(random, kSide);
        const Difference d = difference_of(s, view, SurfaceMode::one_sample);
        CAPTURE(s.code_bits, d.worst, d.pixels);
        CHECK(d.rms() < 4);
    }
}

#ifndef LUMI_TEST_LIGHT  // boards lack the memory
TEST_CASE("colours do not drift over wide triangles, and are the same in every stripe")
{
    TestSurface s = bumpy_ball();
    std::fill(s.texels.begin(), s.texels.end(), uint8_t{128});
    std::minstd_rand random(9);
    double squares = 0, pixels = 0;
    for (int k = 0; k < 6; ++k) {
        const View view = random_view(random, 4 * kSide);
        const Difference d = difference_of(s, view, SurfaceMode::two_by_two);
        squares += d.squares;
        pixels += 3 * static_cast<double>(d.pixels);
        const OpenedSurface opened(file_of(surface_sections(s)));
        REQUIRE(opened.error() == FieldError::none);
        const auto in = [&](const Area& area) {
            return surface_picture(opened.field(), view, SurfaceMode::two_by_two, area);
        };
        const Bytes whole = in({});
        CHECK(in({kMaxImageSide, 3}) == whole);
        CHECK(in({37, 29}) == whole);
    }
    CHECK(squares / pixels < 0.5);
}
#endif
