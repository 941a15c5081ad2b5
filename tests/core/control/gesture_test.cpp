// SPDX-License-Identifier: MIT
#include "lumi/gesture.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace lumi;
using namespace lumi::detail;

namespace
{

constexpr uint32_t kPerPx = degrees(180) / 240;

double in_degrees(uint32_t turns32)
{
    return static_cast<int32_t>(turns32) / 4294967296.0 * 360;
}

// How far an object runs on that was let go at 60 degrees a second or so, and for how many milliseconds.
struct Run {
    double degrees;
    uint32_t ms;
};

Run run_on(uint32_t frame_ms, uint32_t half_life_ms)
{
    OrbitDrag drag({kPerPx, half_life_ms});
    Orbit orbit;
    int32_t x = 0;
    for (int k = 0; k <= 10; ++k, x -= 8) drag.next({true, x, 0}, 100, orbit);
    const uint32_t from = orbit.azimuth_turns32;
    uint32_t ms = 0;
    while (drag.next({false, x, 0}, frame_ms, orbit) && ms < 20000) ms += frame_ms;
    return {in_degrees(orbit.azimuth_turns32 - from), ms};
}

}  // namespace

TEST_CASE("an object follows the finger, pixel by pixel, and not the way to where it is put down")
{
    OrbitDrag drag({kPerPx});
    Orbit orbit = {degrees(10), degrees(20)};
    CHECK(drag.next({true, 200, 100}, 16, orbit));
    CHECK(in_degrees(orbit.azimuth_turns32) == Approx(10));
    CHECK(drag.next({true, 160, 120}, 16, orbit));
    CHECK(in_degrees(orbit.azimuth_turns32) == Approx(10 + 40 * 0.75));
    CHECK(in_degrees(orbit.elevation_turns32) == Approx(20 + 20 * 0.75));
}

TEST_CASE("the eye stays below the pole, from wherever it comes")
{
    OrbitDrag drag({kPerPx});
    Orbit orbit;
    drag.next({true, 0, -32768}, 16, orbit);
    drag.next({true, 0, 32767}, 1, orbit);
    CHECK(in_degrees(orbit.elevation_turns32) == Approx(85));
    drag.next({true, 0, -32768}, 1, orbit);
    CHECK(in_degrees(orbit.elevation_turns32) == Approx(-85));
}

TEST_CASE("an object that is let go runs on, slows down, and rests")
{
    const Run run = run_on(16, 250);
    // Speed over decay: 8 pixels in 100 ms, times the half life over ln 2.
    const double expected = 8 * 0.75 / 0.1 * 0.25 / std::log(2);
    CHECK(run.degrees == Approx(expected).epsilon(0.1));
    CHECK(run.ms > 500);
    CHECK(run.ms < 3000);
    CHECK(run_on(33, 250).degrees == Approx(run.degrees).epsilon(0.05));
    CHECK(run_on(100, 250).degrees == Approx(run.degrees).epsilon(0.05));
    CHECK(run_on(16, 0).ms == 0);
}

TEST_CASE("an object that was held still before it is let go stays")
{
    OrbitDrag drag({kPerPx});
    Orbit orbit;
    for (int32_t k = 0; k < 10; ++k) drag.next({true, 10 * k, 0}, 16, orbit);
    for (int k = 0; k < 20; ++k) drag.next({true, 90, 0}, 16, orbit);
    const uint32_t held = orbit.azimuth_turns32;
    CHECK_FALSE(drag.next({false, 90, 0}, 16, orbit));
    CHECK(orbit.azimuth_turns32 == held);
}

TEST_CASE("an object without a half life, or that nobody looked at for long, stops at once")
{
    for (const uint32_t half_life_ms : {0u, 1u, 10u}) {
        OrbitDrag drag({kPerPx, half_life_ms});
        Orbit orbit;
        for (int32_t x = 0; x < 60; x += 6) (void)drag.next({true, x, 0}, 20, orbit);
        (void)drag.next({false, 60, 0}, half_life_ms == 0 ? 20 : 16 * half_life_ms, orbit);
        const uint32_t azimuth = orbit.azimuth_turns32;
        CHECK_FALSE(drag.next({false, 60, 0}, 20, orbit));
        CHECK(orbit.azimuth_turns32 == azimuth);
    }
}
