// SPDX-License-Identifier: MIT
// Frames of every other scanline.
#include <catch2/catch.hpp>
#include <vector>

#include "chord/drawing.h"
#include "lumi/chord/detail/stepping/outline.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

// Weaves the frame from both halves, drawn by `draw`; whole scanlines of the image.
template <class Draw>
std::vector<uint8_t> woven_frame(const Camera& camera, Draw draw)
{
    const uint32_t stride = static_cast<uint32_t>(camera.width_px());
    std::vector<uint8_t> woven(stride * static_cast<uint32_t>(camera.height_px()));
    for (const int32_t parity : {0, 1}) {
        const Camera half = interlaced_half(camera, parity);
        if (half.height_px() == 0) continue;
        const Stripe scanlines = {
            &woven[static_cast<uint32_t>(parity) * stride], 0, 0, half.width_px(), half.height_px(), 2 * stride};
        REQUIRE(draw(half, scanlines) == RenderError::none);
    }
    return woven;
}

}  // namespace

TEST_CASE("two interlaced halves make the frame", "[camera]")
{
    constexpr int32_t kSide = 33;  // odd: the first half has a scanline more
    const OpenField open(layout_of(100, 130, TexelFormat::luma8),
                         [](uint32_t i, uint32_t k) { return static_cast<uint8_t>(1 + (i * 37 + k * 11) % 255); });
    for (const View& view : extreme_views(kSide)) {
        const Camera camera = camera_of(view);
        const Bytes whole = drawn_frame<Linear, TexelLuma8, PixelGrey8>(open.field, camera, OverBlack{}, 0);
        INFO(view.name);
        const auto draw_by = [&](int32_t span_px) {
            return [&, span_px](const Camera& half, const Stripe& scanlines) {
                return draw_chord<Linear, TexelLuma8, PixelGrey8>(open.field, half, OverBlack{}, scanlines, span_px);
            };
        };
        CHECK(whole == woven_frame(camera, draw_by(0)));
        // By spans a half covers what the frame covers, but for the outline's rounding.
        const Bytes woven = woven_frame(camera, draw_by(16));
        uint32_t differ = 0;
        for (size_t k = 0; k < whole.size(); ++k) differ += (whole[k] == 0) != (woven[k] == 0) ? 1u : 0u;
        CHECK(differ <= 4);
    }
}

TEST_CASE("the outline of an interlaced half is that of its scanlines", "[camera]")
{
    for (const View& view : extreme_views(33)) {
        const Camera camera = camera_of(view);
        for (const int32_t parity : {0, 1}) {
            const Camera half = interlaced_half(camera, parity);
            OutlineTracker outline(half, {0, half.width_px()});
            for (int32_t y = 0; y < half.height_px(); ++y) {
                const Extent span = outline.scanline(y);
                const Extent exact = covered_extent(camera, 2 * y + parity, 0, camera.width_px());
                INFO(view.name << " scanline " << y << " of parity " << parity);
                REQUIRE(std::abs(span.begin - exact.begin) <= 1);
                REQUIRE(std::abs(span.end - exact.end) <= 1);
            }
        }
    }
}
