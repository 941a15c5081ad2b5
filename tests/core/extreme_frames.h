// SPDX-License-Identifier: MIT
// Random frames at the ends of what cameras and stripes may be: a million of each layout under AddressSanitizer and
// UndefinedBehaviorSanitizer by `tools/test.sh --all`, a sample of them elsewhere. No intermediate overflows, nothing
// beside a stripe is touched, and no pixel depends on what memory held before.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <climits>
#include <cmath>

#include "edges.h"
#include "field_bytes.h"
#include "lumi/stripe.h"

namespace lumi::test
{

#if defined(LUMI_EXTREME_FRAMES)
inline constexpr uint32_t kFrames = LUMI_EXTREME_FRAMES;
#elif defined(LUMI_TEST_LIGHT)
inline constexpr uint32_t kFrames = 500;
#else
inline constexpr uint32_t kFrames = 5000;
#endif
inline constexpr int32_t kWindowPx = 15;    // frames of at most 31 × 15 pixels
inline constexpr uint32_t kDrawnTwice = 8;  // every eighth frame is drawn again over other memory

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

}  // namespace lumi::test
