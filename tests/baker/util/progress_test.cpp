// SPDX-License-Identifier: MIT
#include "lumi/baker/progress.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace lumi::baker
{

TEST_CASE("rate meter: knows nothing before two reports")
{
    RateMeter meter(10);
    CHECK(meter.per_second() == 0);
    CHECK(meter.eta_seconds(100) < 0);
    meter.add(5, 0);
    CHECK(meter.per_second() == 0);
    meter.add(5, 10);  // no time has passed
    CHECK(meter.per_second() == 0);
    CHECK(meter.eta_seconds(100) < 0);
}

TEST_CASE("rate meter: a steady pace gives its rate and the time left")
{
    RateMeter meter(10);
    for (int t = 0; t <= 50; ++t) meter.add(t, static_cast<uint64_t>(t) * 20);
    CHECK(meter.per_second() == Approx(20));
    CHECK(meter.eta_seconds(2000) == Approx(50));
    CHECK(meter.eta_seconds(1000) == Approx(0));
}

TEST_CASE("rate meter: forgets what lies before its window")
{
    RateMeter meter(10);
    uint64_t done = 0;
    for (int t = 0; t < 100; ++t) {
        meter.add(t, done);
        done += t < 50 ? 1000 : 10;
    }
    CHECK(meter.per_second() == Approx(10));
}

TEST_CASE("rate meter: a standstill has no end in sight")
{
    RateMeter meter(2);
    for (int t = 0; t < 10; ++t) meter.add(t, 5);
    CHECK(meter.eta_seconds(10) < 0);
}

TEST_CASE("rate meter: work that stands still for a while is expected to go on at half its mean pace")
{
    RateMeter meter(10);
    for (int t = 0; t <= 100; ++t) meter.add(t, 500 + 20 * static_cast<uint64_t>(std::min(t, 50)));
    CHECK(meter.per_second() == 0);
    CHECK(meter.eta_seconds(2000) == Approx(500 / (0.5 * 10)));
    CHECK(meter.eta_seconds(1000) == Approx(0));  // there was more to do than expected
}

}  // namespace lumi::baker
