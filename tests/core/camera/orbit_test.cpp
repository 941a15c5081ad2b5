// SPDX-License-Identifier: MIT
#include "lumi/orbit.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "report.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurn = 4294967296.0;

double fitting_turns(int32_t width, int32_t height, double distance)
{
    const double ratio = static_cast<double>(std::max(width, height)) / std::min(width, height);
    const double half = std::atan(1.06 * ratio / std::sqrt(distance * distance - 1));
    return std::min(std::max(2 * half / (2 * kPi), 1.0 / 360), 1.0 / 3);
}

}  // namespace

TEST_CASE("whole degrees are angles to the nearest step, whatever their sign")
{
    uint32_t wrong = 0;
    for (int32_t d = -1000; d <= 1000; ++d) {
        const double turns = d / 360.0 - std::floor(d / 360.0);
        wrong += degrees(d) != static_cast<uint32_t>(static_cast<uint64_t>(std::llround(turns * kTurn)));
    }
    CHECK(wrong == 0);
    CHECK(degrees(1000000) == degrees(1000000 % 360));
    CHECK(degrees(-1000000) == degrees(-(1000000 % 360)));
}

TEST_CASE("the sphere fits the image from every distance and in every shape, to 1/100 pixel")
{
    double worst = 0;
    for (const auto& [width, height] : {std::make_pair(240, 240), std::make_pair(320, 200), std::make_pair(1, 8192),
                                        std::make_pair(8192, 8192), std::make_pair(128, 64)})
        for (double distance = 1.0005; distance < 2047; distance *= 1.013) {
            const int32_t distance_q20 = static_cast<int32_t>(std::lround(distance * kOneQ20));
            const double turns = fit_sphere(width, height, distance_q20) / kTurn;
            const double expected = fitting_turns(width, height, distance_q20 / static_cast<double>(kOneQ20));
            // Half of the longer side in pixels spans the tangent of half the angle.
            const double scale = std::tan(turns * kPi) / std::tan(expected * kPi);
            worst = std::max(worst, std::abs(scale - 1) * std::max(width, height) / 2);
        }
    INFO("worst, in pixels: " << worst);
    CHECK(worst < 1e-2);
}

TEST_CASE("a field of view that fits lies within what a camera takes")
{
    const int32_t distances[] = {INT32_MIN, 0, kOneQ20, kOneQ20 + 1, radii(3), kMaxEyeDistanceQ20, INT32_MAX};
    for (const int32_t distance : distances)
        for (const auto& [width, height] :
             {std::make_pair(1, 1), std::make_pair(1, 8192), std::make_pair(8192, 8191)}) {
            const uint32_t fov = fit_sphere(width, height, distance);
            CHECK((fov >= kMinFovTurns32 && fov <= kMaxFovTurns32));
        }
}

TEST_CASE("a zoom makes everything so many times as large, to 1/100 pixel, within what a camera takes")
{
    constexpr int32_t kSide = 1000;
    double worst = 0;
    for (const double fov : {5.0, 40.0, 119.0})
        for (const double zoom : {0.5, 0.99, 1.5, 3.0}) {
            const auto fov_turns32 = static_cast<uint32_t>(std::llround(fov / 360 * kTurn));
            const double expected = std::tan(fov / 360 * kPi) / zoom;
            if (2 * std::atan(expected) > 120 / 180.0 * kPi) continue;
            const double turns = zoomed(fov_turns32, static_cast<uint32_t>(std::lround(zoom * kNoZoom))) / kTurn;
            worst = std::max(worst, std::abs(std::tan(turns * kPi) / expected - 1) * kSide / 2);
        }
    INFO("worst, in pixels: " << worst);
    CHECK(worst < 1e-2);
    CHECK(zoomed(degrees(100), kNoZoom / 100) == kMaxFovTurns32);
    CHECK(zoomed(degrees(100), 1) == kMaxFovTurns32);
    CHECK(zoomed(degrees(2), UINT32_MAX) == kMinFovTurns32);
    Orbit orbit;
    const uint32_t fitted = image_of(orbit, 240, 240).fov_turns32;
    orbit.zoom_q16 = 0;
    CHECK(image_of(orbit, 240, 240).fov_turns32 == fitted);
    orbit.zoom_q16 = 2 * kNoZoom;
    CHECK(image_of(orbit, 240, 240).fov_turns32 == zoomed(fitted, 2 * kNoZoom));
    for (const uint32_t wrong : {degrees(130), kMaxFovTurns32 + 1, kMinFovTurns32 - 1}) {  // not repaired by a zoom
        orbit.fov_turns32 = wrong;
        CHECK(image_of(orbit, 240, 240).fov_turns32 == wrong);
    }
    for (const uint32_t right : {kMaxFovTurns32, kMinFovTurns32}) {
        orbit.fov_turns32 = right;
        CHECK(image_of(orbit, 240, 240).fov_turns32 == zoomed(right, orbit.zoom_q16));
    }
}
