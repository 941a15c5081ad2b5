// SPDX-License-Identifier: MIT
#include "lumi/quality.h"

#include <catch2/catch.hpp>
#include <vector>

#include "lumi/surface/frame.h"

using namespace lumi;

namespace
{

constexpr uint32_t kBudget = 33333;

using ChordControl = QualityControl<QualityStep>;

// The time of a frame of each mode where spans of 16 take `spans16`: the ratios of 3×3 over luma8 on an M4.
uint32_t duration(QualityStep mode, uint32_t spans16)
{
    constexpr double kRatio[] = {0.71, 1, 1.1, 1.39, 2, 9.5};
    return static_cast<uint32_t>(kRatio[static_cast<size_t>(mode)] * spans16);
}

// The time of a frame of a surface field, where one sample a pixel takes `one_sample`.
uint32_t duration(SurfaceMode mode, uint32_t one_sample)
{
    constexpr double kRatio[] = {1, 1.5, 2};
    return static_cast<uint32_t>(kRatio[static_cast<size_t>(mode)] * one_sample);
}

template <class Mode>
struct Run {
    std::vector<Mode> modes;
    uint32_t late = 0;
};

// Frames of which one by spans of 16, or by one sample a pixel, takes `unit`.
template <class Mode>
Run<Mode> moving_frames(QualityControl<Mode>& control, uint32_t unit, int count = 60)
{
    Run<Mode> run;
    uint32_t last = 0;
    for (int k = 0; k < count; ++k) {
        const FrameQuality<Mode> q = control.next(last, true);
        CHECK(q.draws);
        last = duration(q.mode, unit);
        run.late += last > kBudget ? 1 : 0;
        run.modes.push_back(q.mode);
    }
    return run;
}

}  // namespace

TEST_CASE("a moving object is drawn as finely as the budget allows", "[quality]")
{
    const struct {
        uint32_t spans16;
        QualityStep expected;
    } cases[] = {{3000, QualityStep::spans4},   {22000, QualityStep::spans4},  {26000, QualityStep::spans8},
                 {33000, QualityStep::spans16}, {46000, QualityStep::one_tap}, {900000, QualityStep::one_tap}};
    for (const auto& c : cases) {
        ChordControl control({kBudget});
        INFO(c.spans16);
        CHECK(moving_frames(control, c.spans16).modes.back() == c.expected);
    }
}

TEST_CASE("moving surfaces are drawn as finely as the budget allows", "[quality]")
{
    const auto mode_at = [](uint32_t one_sample) {
        QualityControl<SurfaceMode> control({kBudget});
        return moving_frames(control, one_sample).modes.back();
    };
    CHECK(mode_at(5000) == SurfaceMode::two_by_two);
    CHECK(mode_at(20000) == SurfaceMode::antialiased);
    CHECK(mode_at(30000) == SurfaceMode::one_sample);
    CHECK(mode_at(90000) == SurfaceMode::one_sample);
}

TEST_CASE("a surface at rest gets its finest picture, once", "[quality]")
{
    QualityControl<SurfaceMode> control({kBudget});
    CHECK(moving_frames(control, 30000).modes.back() == SurfaceMode::one_sample);
    CHECK(control.next(30000, false).mode == SurfaceMode::one_sample);
    CHECK(control.next(30000, false).mode == SurfaceMode::antialiased);
    CHECK(control.next(45000, false).mode == SurfaceMode::two_by_two);
    CHECK_FALSE(control.next(60000, false).draws);
    CHECK(control.next(60000, true).mode == SurfaceMode::one_sample);
}

TEST_CASE("a slow frame takes at most two frames to get back below the budget", "[quality]")
{
    ChordControl control({kBudget});
    CHECK(moving_frames(control, 20000).late == 0);
    const Run<QualityStep> slower = moving_frames(control, 44000);
    CHECK(slower.late <= 3);
    CHECK(slower.modes.back() == QualityStep::one_tap);
}

TEST_CASE("quality does not swing where the next step is just too dear", "[quality]")
{
    // One tap leaves so much room that spans of 16 are tried, and they are too slow.
    ChordControl control({kBudget});
    uint32_t last = 0;
    uint32_t late = 0;
    for (int k = 0; k < 1000; ++k) {
        last = control.next(last, true).mode <= QualityStep::one_tap ? 15000 : 60000;
        late += last > kBudget ? 1 : 0;
    }
    CHECK(late <= 12);
}

TEST_CASE("at rest every frame is finer, whole, and the last one exact", "[quality]")
{
    ChordControl control({kBudget});
    const QualityStep moving = moving_frames(control, 80000, 20).modes.back();
    QualityStep before = QualityStep::one_tap;
    for (FrameQuality<QualityStep> q = control.next(1, false); q.draws; q = control.next(900000, false)) {
        CHECK(q.mode > before);
        before = q.mode;
    }
    CHECK(before == QualityStep::exact);
    CHECK_FALSE(control.next(0, false).draws);
    // The slow frames at rest do not count once it moves again.
    const FrameQuality<QualityStep> again = control.next(900000, true);
    CHECK(again.draws);
    CHECK(again.mode == moving);
}

TEST_CASE("quality stays within its limits", "[quality]")
{
    ChordControl control({kBudget, QualityStep::spans16, QualityStep::spans8, QualityStep::spans4});
    for (const uint32_t spans16 : {1000u, 500000u, 1000u, 0u}) {
        for (const QualityStep mode : moving_frames(control, spans16, 50).modes) {
            CHECK(mode >= QualityStep::spans16);
            CHECK(mode <= QualityStep::spans8);
        }
    }
    FrameQuality<QualityStep> q = control.next(0, false);
    for (; q.draws; q = control.next(0, false)) CHECK(q.mode <= QualityStep::spans4);
    CHECK(q.mode == QualityStep::spans4);
}

TEST_CASE("equal calls give equal answers", "[quality]")
{
    ChordControl a({kBudget}), b({kBudget});
    for (uint32_t k = 0; k < 500; ++k) {
        const uint32_t last = (k * 2654435761u) >> 15;
        const bool moving = (k >> 5) % 3 != 0;
        const FrameQuality<QualityStep> qa = a.next(last, moving), qb = b.next(last, moving);
        REQUIRE(qa.draws == qb.draws);
        REQUIRE(qa.mode == qb.mode);
    }
}

TEST_CASE("steps of chord fields have the spans of their names", "[quality]")
{
    const int32_t spans[] = {16, 16, 8, 4, 2, 1};
    for (uint8_t k = 0; k < 6; ++k) CHECK(span_px_of(static_cast<QualityStep>(k)) == spans[k]);
}
