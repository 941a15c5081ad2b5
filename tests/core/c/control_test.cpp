// SPDX-License-Identifier: MIT
// Gestures, quality control and packed greys from C: the numbers of C++.
#include <random>

#include "c/views.h"
#include "lumi/gesture.h"
#include "lumi/pack.h"
#include "lumi/quality.h"

using namespace lumi;
using namespace lumi::test;

namespace
{

constexpr uint32_t kBudget = 33333;
constexpr lumi_drag_settings kSettings = {LUMI_DEGREES(180) / 240, 250, LUMI_DEGREES(85)};

// A finger that comes and goes, and frames that take from a quarter to four times the budget.
class Chance
{
public:
    uint32_t below(uint32_t limit) { return static_cast<uint32_t>(random_() % limit); }

    lumi_touch touch()
    {
        if (below(9) == 0) touch_.is_down = !touch_.is_down;
        touch_.x_px += static_cast<int32_t>(below(41)) - 20;
        touch_.y_px += static_cast<int32_t>(below(41)) - 20;
        return touch_;
    }

    // For some hundred frames light, then heavy.
    uint32_t frame(int k) { return kBudget / 4 + below(k / 300 % 2 == 0 ? kBudget / 2 : 4 * kBudget); }

private:
    std::mt19937 random_{7};
    lumi_touch touch_ = {false, 100, 100};
};

// next(last_frame, is_moving) is what C++ answers; mode_of(its answer) the mode of C.
template <class Quality, class ModeOf>
void check_control(const lumi_view* view, const lumi_quality_limits& limits, Quality quality, ModeOf mode_of)
{
    control_in_c c = {};
    REQUIRE(start_control_in_c(&c, view, kSettings, limits) == 0);
    OrbitDrag drag({kSettings.turns32_per_px, kSettings.half_life_ms, kSettings.elevation_limit});
    Orbit orbit = {degrees(30), degrees(20), radii(3)};
    Chance chance;
    std::vector<uint32_t> modes(17), moved(2);
    for (int k = 0; k < 3000; ++k) {
        const lumi_touch touch = chance.touch();
        const uint32_t elapsed_ms = chance.below(40), last = chance.frame(k);
        const lumi_frame_quality by_c = next_control_in_c(&c, touch, elapsed_ms, last);
        const bool is_moving = drag.next({touch.is_down, touch.x_px, touch.y_px}, elapsed_ms, orbit);
        const auto by_cpp = quality.next(last, is_moving);
        REQUIRE(by_c.draws == by_cpp.draws);
        REQUIRE(by_c.mode == mode_of(by_cpp));
        REQUIRE(c.orbit.azimuth_turns32 == orbit.azimuth_turns32);
        REQUIRE(c.orbit.elevation_turns32 == orbit.elevation_turns32);
        ++modes[by_c.mode], ++moved[is_moving ? 1 : 0];
    }
    for (const uint8_t mode : {limits.coarsest, limits.finest_moving}) CHECK(modes[mode] > 10);
    CHECK((moved[0] > 100 && moved[1] > 100));
}

}  // namespace

TEST_CASE("a finger and a budget choose the same orbits and modes from C, for surface fields")
{
    const ViewInC view(surface_bytes(), LUMI_TWO_BY_TWO);
    const auto mode_of = [](const FrameQuality<SurfaceMode>& q) { return static_cast<uint8_t>(q.mode); };
    using Control = QualityControl<SurfaceMode>;
    check_control(view.get(), {kBudget, LUMI_ONE_SAMPLE, LUMI_TWO_BY_TWO, LUMI_TWO_BY_TWO}, Control({kBudget}),
                  mode_of);
    check_control(view.get(), {kBudget, LUMI_ANTIALIASED, LUMI_ANTIALIASED, LUMI_TWO_BY_TWO},
                  Control({kBudget, SurfaceMode::antialiased, SurfaceMode::antialiased}), mode_of);
}

TEST_CASE("limits of quality that are no modes, in the wrong order or too fine are errors in C")
{
    const ViewInC view(surface_bytes(), LUMI_ANTIALIASED);
    lumi_quality quality;
    const auto error = [&](const lumi_quality_limits& limits) {
        return lumi_quality_start(&quality, view.get(), limits);
    };
    CHECK(error({kBudget, 0, 1, 1}) == 0);
    CHECK(error({(1u << 29) - 1, 0, 0, 1}) == 0);
    CHECK(error({1u << 29, 0, 1, 1}) == code(ViewError::bad_argument));
    CHECK(error({kBudget, 1, 0, 1}) == code(ViewError::bad_argument));
    CHECK(error({kBudget, 1, 1, 0}) == code(ViewError::bad_argument));
    CHECK(error({kBudget, 0, 3, 1}) == code(ViewError::bad_argument));
    CHECK(error({kBudget, 0, 1, 16}) == code(ViewError::bad_argument));
    CHECK(error({kBudget, 0, 2, 1}) == code(ViewError::mode_too_fine));
    CHECK(error({kBudget, 0, 1, 2}) == code(ViewError::mode_too_fine));
    CHECK(lumi_quality_start(&quality, nullptr, {kBudget, 0, 1, 1}) == code(ViewError::no_field));
    CHECK(lumi_quality_start(nullptr, view.get(), {kBudget, 0, 1, 1}) == code(ViewError::bad_argument));
}

#ifdef LUMI_C_TEXEL
TEST_CASE("a budget chooses the same spans from C, for chord fields")
{
    const ViewInC view(chord_bytes(TexelFormat::rgb565), 16);
    using Control = QualityControl<QualityStep>;
    const auto mode_of = [](const FrameQuality<QualityStep>& q) {
        CHECK(q.mode >= QualityStep::spans16);
        return static_cast<uint8_t>(span_px_of(q.mode));
    };
    check_control(view.get(), {kBudget, 16, 4, 2},
                  Control({kBudget, QualityStep::spans16, QualityStep::spans4, QualityStep::spans2}), mode_of);
    check_control(view.get(), {kBudget, 8, 2, 2},
                  Control({kBudget, QualityStep::spans8, QualityStep::spans2, QualityStep::spans2}), mode_of);
    lumi_quality quality;
    const auto error = [&](const lumi_quality_limits& limits) {
        return lumi_quality_start(&quality, view.get(), limits);
    };
    CHECK(error({kBudget, 16, 16, 16}) == 0);
    const uint8_t wrong_spans[] = {0, 1, 3, 32};
    for (const uint8_t wrong : wrong_spans) {
        CHECK(error({kBudget, wrong, 4, 2}) == code(ViewError::bad_argument));
        CHECK(error({kBudget, 16, wrong, 2}) == code(ViewError::bad_argument));
        CHECK(error({kBudget, 16, 4, wrong}) == code(ViewError::bad_argument));
    }
    CHECK(error({kBudget, 4, 8, 2}) == code(ViewError::bad_argument));
    CHECK(error({kBudget, 16, 2, 4}) == code(ViewError::bad_argument));
}
#endif

TEST_CASE("greys are packed from C as by C++")
{
    constexpr int32_t kWide = 37, kHigh = 24;
    constexpr uint32_t kGrey4 = LUMI_GREY4_BYTES(kWide) + 4, kMono1 = LUMI_MONO1_BYTES(kWide) + 4, kPages = kWide + 4;
    static_assert(LUMI_GREY4_BYTES(kWide) == grey4_bytes(kWide) && LUMI_MONO1_BYTES(kWide) == mono1_bytes(kWide));
    Bytes grey;
    for (uint32_t k = 0; k < kWide * kHigh; ++k) grey.push_back(static_cast<uint8_t>(scattered(k)));
    const auto filled = [](uint32_t bytes) { return Bytes(bytes, 0x5A); };
    Bytes by_c[] = {filled(kGrey4 * kHigh), filled(kMono1 * kHigh), filled(kPages * kHigh / 8)};
    Bytes by_cpp[] = {by_c[0], by_c[1], by_c[2]};
    pack_in_c({grey.data(), 3, 16, kWide, kHigh, kWide}, by_c[0].data(), by_c[1].data(), by_c[2].data());
    const Stripe stripe = {grey.data(), 3, 16, kWide, kHigh, kWide};
    pack_grey4(stripe, by_cpp[0].data(), kGrey4);
    pack_mono1(stripe, by_cpp[1].data(), kMono1);
    pack_pages(stripe, by_cpp[2].data(), kPages);
    for (int k = 0; k < 3; ++k) {
        CHECK((by_c[k] == by_cpp[k]));
        CHECK((by_c[k] != filled(static_cast<uint32_t>(by_c[k].size()))));
    }
}

TEST_CASE("colours are dithered from C as by C++")
{
    constexpr int32_t kWide = 24, kHigh = 8;
    Bytes rgb, by_c[2], by_cpp[2];
    for (uint32_t k = 0; k < 3 * kWide * kHigh; ++k) rgb.push_back(static_cast<uint8_t>(scattered(k)));
    for (Bytes* bytes : {by_c, by_cpp}) bytes[0] = bytes[1] = Bytes(2 * kWide * kHigh);
    dither_in_c({rgb.data(), 3, 5, kWide, kHigh, 3 * kWide}, by_c[0].data(), by_c[1].data());
    dither_rgb565({rgb.data(), 3, 5, kWide, kHigh, 3 * kWide}, by_cpp[0].data(), 2 * kWide);
    dither_rgb565_swapped({rgb.data(), 3, 5, kWide, kHigh, 3 * kWide}, by_cpp[1].data(), 2 * kWide);
    CHECK((by_c[0] == by_cpp[0] && by_c[1] == by_cpp[1] && by_c[0] != by_c[1]));
}
