// SPDX-License-Identifier: MIT
// Random frames at the ends of what cameras and stripes may be. No intermediate overflows, nothing beside a stripe is
// touched, and no pixel depends on what memory held before. The fuzz target `extreme` draws many more of them.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <climits>
#include <cmath>
#include <cstdio>

#include "edges.h"
#include "field_bytes.h"
#include "lumi/stripe.h"

namespace lumi::test
{

#ifdef LUMI_TEST_LIGHT
inline constexpr uint32_t kFrames = 500;
#else
inline constexpr uint32_t kFrames = 5000;
#endif
inline constexpr int32_t kWindowPx = 15;    // frames of at most 31 × 15 pixels
inline constexpr uint32_t kDrawnTwice = 8;  // every eighth frame is drawn again over other memory
// Frames of generated fields (extreme_chords.h, extreme_surfaces.h): these have up to 8192 triangles, and each is drawn
// in several frames.
inline constexpr uint32_t kGeneratedFrames = 500 + kFrames / 10, kFramesAField = 16;

// A frame, and the stripe of it that is drawn.
struct Extreme {
    Edge edge;
    uint32_t choice;  // any number: of what the test draws
};

// Looks to the right instead: if the sphere was ahead, the eye now lies as far to the side of its axis as it is away.
inline void look_aside(Pose& pose)
{
    const Vec3q30 ahead = pose.forward;
    pose.forward = pose.right;
    pose.right = {-ahead.x, -ahead.y, -ahead.z};
}

class Extremes
{
public:
    explicit Extremes(uint32_t seed) : edges_(seed, kWindowPx) {}

    Extreme next()
    {
        const double fovs[] = {1, 2, 45, 120, edges_.uniform(1, 120)};
        Extreme e{edges_.next(distance(), fovs[below(5)]), below(1u << 24)};
        if (below(4) == 0) stretch(e.edge);
        if (below(4) == 0) bend(e.edge.pose);
        if (below(8) == 0) look_aside(e.edge.pose);
        if (below(8) == 0) e.edge.x += static_cast<int32_t>(below(80)) - 40;
        if (below(8) == 0) e.edge.y += static_cast<int32_t>(below(80)) - 40;
        const int32_t ends[] = {INT_MIN, -32769, 16384, 32767, INT_MAX - 64};  // nothing lies beyond INT_MAX
        if (below(64) == 0) e.edge.x = ends[below(5)];
        if (below(64) == 0) e.edge.y = ends[below(5)];
        return e;
    }

    uint32_t below(uint32_t count) { return static_cast<uint32_t>(edges_.uniform(0, count)); }

private:
    // To sides at their ends, in every proportion; the window lies at an end of the image or in it.
    void stretch(Edge& edge)
    {
        const int32_t sides[] = {1, 2, 3, kMaxImageSide - 1, kMaxImageSide};
        const auto shift_q8 = [&](int32_t side) { return 256 * side * (static_cast<int32_t>(below(3)) - 1); };
        const auto place = [&](int32_t side, int32_t& at, int32_t& size) {
            size = std::min(side, size);
            const uint32_t end = static_cast<uint32_t>(side - size), choice = below(3);
            at = static_cast<int32_t>(choice == 0 ? 0 : choice == 1 ? end : below(end + 1));
        };
        Image& image = edge.image;
        image.width_px = sides[below(5)];
        image.height_px = sides[below(5)];
        image.shift_x_q8 = shift_q8(image.width_px);
        image.shift_y_q8 = shift_q8(image.height_px);
        edge.width = 2 * kWindowPx + 1;
        edge.height = kWindowPx;
        place(image.width_px, edge.x, edge.width);
        place(image.height_px, edge.y, edge.height);
    }

    // Makes axes longer or shorter by nearly as much as a camera takes: their squares differ from 1 by 2^-12.
    void bend(Pose& pose)
    {
        for (Vec3q30* axis : {&pose.right, &pose.up, &pose.forward}) {
            const double scale = 1 + 0.98 * std::ldexp(static_cast<double>(below(3)) - 1, -13);
            for (int32_t* c : {&axis->x, &axis->y, &axis->z}) *c = static_cast<int32_t>(*c * scale);
        }
    }

    // On the sphere, just above it, and as far away as eyes go.
    double distance()
    {
        const double ends[] = {1, 1.0001, 1.01, 2047};
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

// Checks that at least so many bytes a frame show something of the fields, and not the background.
inline void check_shown(const char* of, uint32_t frames, uint64_t shown, uint64_t least)
{
    std::printf("%u extreme frames of %s, %llu bytes show something\n", static_cast<unsigned>(frames), of,
                static_cast<unsigned long long>(shown));
    CHECK(shown > least * frames);
}

}  // namespace lumi::test
