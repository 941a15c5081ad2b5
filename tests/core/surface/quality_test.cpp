// SPDX-License-Identifier: MIT
#include "lumi/surface/quality.h"

#include <catch2/catch.hpp>

using namespace lumi;
using namespace lumi::detail;

namespace
{

constexpr uint32_t kBudget = 33333;

// On a board where one sample a pixel takes so long.
uint32_t duration(SurfaceMode mode, uint32_t one_sample)
{
    return mode == SurfaceMode::one_sample    ? one_sample
           : mode == SurfaceMode::antialiased ? one_sample * 3 / 2
                                              : one_sample * 2;
}

SurfaceMode settled(SurfaceQuality& control, uint32_t one_sample)
{
    uint32_t last = 0;
    SurfaceMode mode = SurfaceMode::one_sample;
    for (int k = 0; k < 60; ++k) {
        const SurfaceFrameQuality q = control.next(last, true);
        CHECK(q.draws);
        mode = q.mode;
        last = duration(mode, one_sample);
    }
    return mode;
}

}  // namespace

TEST_CASE("moving surfaces are drawn as finely as the budget allows", "[quality]")
{
    const auto mode_at = [](uint32_t one_sample) {
        SurfaceQuality control({kBudget});
        return settled(control, one_sample);
    };
    CHECK(mode_at(5000) == SurfaceMode::two_by_two);
    CHECK(mode_at(20000) == SurfaceMode::antialiased);
    CHECK(mode_at(30000) == SurfaceMode::one_sample);
    CHECK(mode_at(90000) == SurfaceMode::one_sample);
}

TEST_CASE("a surface at rest gets its finest picture, once", "[quality]")
{
    SurfaceQuality control({kBudget});
    CHECK(settled(control, 30000) == SurfaceMode::one_sample);
    CHECK(control.next(30000, false).mode == SurfaceMode::one_sample);
    CHECK(control.next(30000, false).mode == SurfaceMode::antialiased);
    CHECK(control.next(45000, false).mode == SurfaceMode::two_by_two);
    CHECK_FALSE(control.next(60000, false).draws);
    CHECK(control.next(60000, true).mode == SurfaceMode::one_sample);
}

TEST_CASE("limits bound the modes of surfaces", "[quality]")
{
    SurfaceQuality control({kBudget, SurfaceMode::antialiased, SurfaceMode::antialiased, SurfaceMode::antialiased});
    CHECK(settled(control, 1000) == SurfaceMode::antialiased);
    CHECK(settled(control, 90000) == SurfaceMode::antialiased);
    CHECK(control.next(1000, false).mode == SurfaceMode::antialiased);
    CHECK_FALSE(control.next(1000, false).draws);
}
