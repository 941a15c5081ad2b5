// SPDX-License-Identifier: MIT
// Which pixels the span renderer hands to inner loops: each of the sphere's once, most of them in tiles.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "chord/drawing.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int32_t kSide = 96;
constexpr double kLeastShare = 0.3;  // measured: 0.36
#else
constexpr int32_t kSide = 240;
constexpr double kLeastShare = 0.6;  // measured: 0.67
#endif
constexpr uint8_t kOfSpan = 1;
constexpr uint8_t kOfTile = 2;
constexpr uint8_t kChecked = 4;

struct Marks : Nearest {
};

}  // namespace

namespace lumi::detail
{

// Adds to its pixels, so that one drawn twice shows.
template <>
struct SpanDraw<Marks> {
    template <class Texel, class Pixel, class Background>
    static void draw(CellPiece<Background>& span)
    {
        static_assert(Pixel::kBytes == 1);
        int32_t scanlines_left = span.scanlines();
        span.go_to_first();
        do {
            const uint8_t mark = span.tile != nullptr ? kOfTile : kOfSpan;
            for (int32_t k = 0; k < span.length; ++k) span.pixels[k] = static_cast<uint8_t>(span.pixels[k] + mark);
        } while (span.go_down(scanlines_left));
    }
    template <class Texel, class Pixel, class Background>
    static void draw_checked(const CheckedPiece<Background>& span)
    {
        for (int32_t k = 0; k < span.length; ++k) span.pixels[k] = static_cast<uint8_t>(span.pixels[k] + kChecked);
    }
};

}  // namespace lumi::detail

namespace
{

// The share of covered pixels that lie in tiles; every pixel is checked. Scanlines are drawn `height` at a time.
double share_of_tiles(const Field& field, const Camera& camera, int32_t height)
{
    Bytes pixels;
    for (int32_t y = 0; y < kSide; y += height) {
        const Bytes stripe = drawn_window<Marks, TexelLuma8, PixelGrey8>(field, camera, OverBlack{}, 16, 0, y, kSide,
                                                                         std::min(height, kSide - y));
        pixels.insert(pixels.end(), stripe.begin(), stripe.end());
    }
    int covered = 0;
    int in_tiles = 0;
    int wrong = 0;
    for (int32_t y = 0; y < kSide; ++y) {
        const Extent span = covered_extent(camera, y, 0, kSide);
        for (int32_t x = 0; x < kSide; ++x) {
            const uint8_t mark = pixels[static_cast<size_t>(y * kSide + x)];
            const bool is_drawn = mark == kOfSpan || mark == kOfTile || mark == kChecked;
            if (x >= span.begin && x < span.end) ++covered;
            if (mark == kOfTile) ++in_tiles;
            // Where the outline passes, its rounding and that of rays may differ by a pixel.
            const bool is_edge = std::abs(x - span.begin) <= 1 || std::abs(x - span.end) <= 1;
            if (mark != 0 && !is_drawn) ++wrong;
            if (!is_edge && is_drawn != (x >= span.begin && x < span.end)) ++wrong;
        }
    }
    CHECK(wrong == 0);
    return covered > 0 ? in_tiles / static_cast<double>(covered) : 0;
}

}  // namespace

TEST_CASE("each pixel of the sphere is drawn once, most of them in tiles", "[span]")
{
    const OpenField open(layout_of(300, 700, TexelFormat::luma8), [](uint32_t, uint32_t) { return uint8_t{1}; });
    for (const View& view : extreme_views(kSide)) {
        if (view.image.width_px != kSide || view.image.height_px != kSide) continue;
        const Camera camera = camera_of(view);
        INFO(view.name);
        const double share = share_of_tiles(open.field, camera, 16);
        CHECK(share == share_of_tiles(open.field, camera, kSide));
        CHECK(share == share_of_tiles(open.field, camera, 5));
        if (view.name == "generic") CHECK(share > kLeastShare);
    }
}
