// SPDX-License-Identifier: MIT
#include "lumi/chord/quality.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "field_bytes.h"
#include "lumi/chord/render_spans.h"
#include "views.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::test;

namespace
{

constexpr uint32_t kBudget = 33333;

// What a frame of each step takes on a board where spans of 16 take `spans16`: the ratios of 3×3 over luma8 on an M4.
uint32_t duration(const FrameQuality& q, uint32_t spans16)
{
    const double base = q.one_tap         ? 0.71
                        : q.span_px == 16 ? 1
                        : q.span_px == 8  ? 1.1
                        : q.span_px == 4  ? 1.39
                        : q.span_px == 2  ? 2
                                          : 9.5;
    return static_cast<uint32_t>(base * (q.interlaced ? 0.5 : 1) * spans16);
}

struct Run {
    std::vector<QualityStep> steps;
    uint32_t late = 0;
};

Run moving_frames(QualityControl& control, uint32_t spans16, int count)
{
    Run run;
    uint32_t last = 0;
    for (int k = 0; k < count; ++k) {
        const FrameQuality q = control.next(last, true);
        CHECK(q.draws);
        last = duration(q, spans16);
        run.late += last > kBudget ? 1 : 0;
        run.steps.push_back(control.step());
    }
    return run;
}

}  // namespace

TEST_CASE("a moving object is drawn as finely as the budget allows", "[quality]")
{
    const struct {
        uint32_t spans16;
        QualityStep expected;
    } cases[] = {{3000, QualityStep::spans4},
                 {22000, QualityStep::spans4},
                 {26000, QualityStep::spans8},
                 {33000, QualityStep::spans16},
                 {46000, QualityStep::one_tap},
                 {80000, QualityStep::one_tap_interlaced},
                 {900000, QualityStep::one_tap_interlaced}};
    for (const auto& c : cases) {
        QualityControl control({kBudget});
        const Run run = moving_frames(control, c.spans16, 60);
        INFO(c.spans16);
        CHECK(run.steps.back() == c.expected);
    }
}

TEST_CASE("a slow frame takes at most two frames to get back below the budget", "[quality]")
{
    QualityControl control({kBudget});
    CHECK(moving_frames(control, 20000, 60).late == 0);
    const Run slower = moving_frames(control, 44000, 60);
    CHECK(slower.late <= 3);
    CHECK(slower.steps.back() == QualityStep::one_tap);
}

TEST_CASE("quality does not swing where the next step is just too dear", "[quality]")
{
    // One tap leaves so much room that spans of 16 are tried, and they are too slow: as with the paper's kernel.
    QualityControl control({kBudget});
    uint32_t last = 0;
    uint32_t late = 0;
    for (int k = 0; k < 1000; ++k) {
        const FrameQuality q = control.next(last, true);
        last = q.one_tap ? 15000 : 60000;
        late += last > kBudget ? 1 : 0;
    }
    CHECK(late <= 12);
}

TEST_CASE("at rest every frame is finer, whole, and the last one exact", "[quality]")
{
    QualityControl control({kBudget});
    (void)moving_frames(control, 80000, 20);
    const QualityStep moving = control.step();
    QualityStep before = QualityStep::one_tap;
    for (FrameQuality q = control.next(1, false); q.draws; q = control.next(900000, false)) {
        CHECK(control.step() > before);
        CHECK_FALSE(q.interlaced);
        CHECK_FALSE(q.one_tap);
        before = control.step();
    }
    CHECK(before == QualityStep::exact);
    CHECK_FALSE(control.next(0, false).draws);
    // The slow frames at rest do not count once it moves again.
    CHECK(control.next(900000, true).draws);
    CHECK(control.step() == moving);
}

TEST_CASE("quality stays within its limits", "[quality]")
{
    QualityLimits limits{kBudget};
    limits.coarsest = QualityStep::spans16;
    limits.finest_moving = QualityStep::spans8;
    limits.finest_resting = QualityStep::spans4;
    QualityControl control(limits);
    for (const uint32_t spans16 : {1000u, 500000u, 1000u, 0u}) {
        for (const QualityStep step : moving_frames(control, spans16, 50).steps) {
            CHECK(step >= QualityStep::spans16);
            CHECK(step <= QualityStep::spans8);
        }
    }
    while (control.next(0, false).draws) CHECK(control.step() <= QualityStep::spans4);
    CHECK(control.step() == QualityStep::spans4);
}

TEST_CASE("equal calls give equal answers, and fields alternate", "[quality]")
{
    QualityControl a({kBudget});
    QualityControl b({kBudget});
    int32_t parity = 1;
    for (uint32_t k = 0; k < 500; ++k) {
        const uint32_t last = (k * 2654435761u) >> 15;
        const bool moving = (k >> 5) % 3 != 0;
        const FrameQuality qa = a.next(last, moving);
        const FrameQuality qb = b.next(last, moving);
        REQUIRE(qa.draws == qb.draws);
        REQUIRE(qa.one_tap == qb.one_tap);
        REQUIRE(qa.interlaced == qb.interlaced);
        REQUIRE(qa.span_px == qb.span_px);
        REQUIRE(qa.parity == qb.parity);
        REQUIRE(qa.parity == (parity ^= 1));
    }
}

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

TEST_CASE("two interlaced halves make the frame", "[quality]")
{
    constexpr int32_t kSide = 33;  // odd: the first half has a scanline more
    TestLayout layout;
    layout.origins = 100;
    layout.used_origins = 100;
    layout.directions = 130;
    layout.texel = TexelFormat::luma8;
    const Bytes bytes = file_of({layout_section(layout), texel_section(layout, [](uint32_t i, uint32_t k) {
                                     return static_cast<uint8_t>(1 + (i * 37 + k * 11) % 255);
                                 })});
    Field field;
    REQUIRE(open_field(bytes.data(), bytes.size(), field) == FieldError::none);
    for (const View& view : extreme_views(kSide)) {
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
        const uint32_t stride = static_cast<uint32_t>(camera.width_px());
        std::vector<uint8_t> whole(stride * static_cast<uint32_t>(camera.height_px()));
        const Stripe stripe = {whole.data(), 0, 0, camera.width_px(), camera.height_px(), stride};
        REQUIRE(render<Linear, TexelLuma8, PixelGrey8>(field, camera, OverBlack{}, stripe) == RenderError::none);
        INFO(view.name);
        const auto exact = [&](const Camera& half, const Stripe& scanlines) {
            return render<Linear, TexelLuma8, PixelGrey8>(field, half, OverBlack{}, scanlines);
        };
        CHECK(whole == woven_frame(camera, exact));
        // By spans a half covers what the frame covers, but for the outline's rounding.
        const auto spans = [&](const Camera& half, const Stripe& scanlines) {
            return render_spans<Linear, TexelLuma8, PixelGrey8>(field, half, OverBlack{}, scanlines, 16);
        };
        const std::vector<uint8_t> woven = woven_frame(camera, spans);
        uint32_t differ = 0;
        for (size_t k = 0; k < whole.size(); ++k) differ += (whole[k] == 0) != (woven[k] == 0) ? 1u : 0u;
        CHECK(differ <= 4);
    }
}

TEST_CASE("the outline of an interlaced half is that of its scanlines", "[quality]")
{
    for (const View& view : extreme_views(33)) {
        Camera camera;
        REQUIRE(make_camera(view.pose, view.image, camera) == CameraError::none);
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
