// SPDX-License-Identifier: MIT
#include "surface/planes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "surface/projection.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

// Coordinates as a plane holds them, u in the lower half, which borrows from the upper one.
uint32_t both(int32_t u, int32_t v)
{
    return (static_cast<uint32_t>(v) << 16) + static_cast<uint32_t>(u);
}

// Twice the area of a, b and a place; negative on the inner side of the edge.
int32_t side_of(const SurfaceVertex& a, const SurfaceVertex& b, int32_t x, int32_t y)
{
    return (x_q6(b) - x_q6(a)) * (y - y_q6(a)) - (x - x_q6(a)) * (y_q6(b) - y_q6(a));
}

}  // namespace

TEST_CASE("samples are hardly nearer than the nearest corner of their triangle, slivers among them")
{
    std::minstd_rand random(3);
    const auto any = [&](uint32_t count) { return static_cast<int32_t>(random() % count); };
    uint32_t samples = 0, wrong = 0;
    for (int k = 0; k < 60000; ++k) {
        const uint32_t size = 16u << (k % 8);  // a quarter sample to 32
        const uint32_t range = 1u << (k % 16);
        const int32_t near = 256 + any(65024 - range);
        SurfaceVertex v[3];
        for (SurfaceVertex& vertex : v)
            vertex = packed({640 + any(size), 640 + any(size), static_cast<uint32_t>(near + any(range))}, 0);
        if (side_of(v[0], v[1], x_q6(v[2]), y_q6(v[2])) >= 0) continue;
        const Corner a = {&v[0], 0, 0}, b = {&v[1], 0, 0}, c = {&v[2], 0, 0};
        Facing f = {&a, &b, &c, between(v[0], v[1]), between(v[0], v[2])};
        const auto area = static_cast<uint32_t>(-doubled_area(f.ab, f.ac));
        const auto [left, right] = std::minmax({x_q6(v[0]), x_q6(v[1]), x_q6(v[2])});
        const auto [top, bottom] = std::minmax({y_q6(v[0]), y_q6(v[1]), y_q6(v[2])});
        const auto [far, nearest] = std::minmax({depth_of(v[0]), depth_of(v[1]), depth_of(v[2])});
        const uint32_t beyond = ((nearest - far) >> 6) + 2;
        const Shares shares = shares_of(f, area, std::max(right - left, bottom - top));
        const Plane depth = PlaneMaker(f, shares, 0, 0).depth();
        for (int32_t y = line_from(top); y < line_from(bottom); ++y) {
            for (int32_t x = line_from(left); x < line_from(right); ++x) {
                const int32_t at_x = 64 * x + 32, at_y = 64 * y + 32;
                if (side_of(v[0], v[1], at_x, at_y) > 0 || side_of(v[1], v[2], at_x, at_y) > 0 ||
                    side_of(v[2], v[0], at_x, at_y) > 0)
                    continue;
                const uint32_t at =
                    (depth.value + depth.right * static_cast<uint32_t>(x) + depth.down * static_cast<uint32_t>(y)) >>
                    16;
                ++samples;
                wrong += at > nearest + beyond || at + beyond < far ? 1u : 0u;
            }
        }
    }
    CHECK(samples > 100000);
    CHECK(wrong == 0);
}

TEST_CASE("a texture's steps of any size tell whether it is magnified")
{
    constexpr int32_t kLeast = -32768, kMost = 32767, kMagnified = 512;
    const int32_t others[] = {kLeast, kLeast + 1, -kMagnified - 1, -kMagnified,    -1,
                              0,      1,          kMagnified,      kMagnified + 1, kMost};
    uint32_t wrong = 0;
    for (const int32_t other : others) {
        for (int32_t v = kLeast; v <= kMost; ++v) {
            const auto fits = [](int32_t step) { return -kMagnified <= step && step <= kMagnified; };
            const bool expected = fits(other) && fits(v);
            const auto is_wrong = [&](uint32_t right, uint32_t down) {
                return is_magnified(right, down, kMagnified) != expected;
            };
            wrong += is_wrong(both(other, v), 0) ? 1u : 0u;
            wrong += is_wrong(both(v, other), 0) ? 1u : 0u;
            wrong += is_wrong(0, both(other, v)) ? 1u : 0u;
            wrong += is_wrong(0, both(v, other)) ? 1u : 0u;
        }
    }
    CHECK(wrong == 0);
}
