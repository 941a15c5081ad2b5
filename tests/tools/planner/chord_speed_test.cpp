// SPDX-License-Identifier: MIT
// How fast parts draw chord fields.
#include "planner/speed.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lumi/bench/views.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::planner
{

namespace
{

using tools::Mode;

// A field in memory, on request at an odd address, where spans refuse RGB565.
class Opened
{
public:
    explicit Opened(uint32_t origins, uint32_t directions, TexelFormat texel = TexelFormat::rgb888, bool is_odd = false)
    {
        tools::test::TestField layout;
        layout.origins = layout.used_origins = origins;
        layout.directions = directions;
        layout.texel = texel;
        const std::string file = tools::test::field_bytes(layout), before(is_odd ? 1 : 0, '\0');
        bytes_ = before + file;
        REQUIRE(open_field(reinterpret_cast<const uint8_t*>(bytes_.data()) + before.size(), file.size(), field) ==
                FieldError::none);
    }

    Field field;

private:
    std::string bytes_;
};

struct Frame {
    const char *core, *view;
    std::string mode;
    int span_px;  // 0: every pixel exact
};

// Instructions of a frame of the desk clock, 1024 × 2048 rays of RGB565, that `lumi-lab bench --docs` wrote down.
double counted(const Frame& wanted)
{
    static const auto bench = nlohmann::json::parse(tools::test::content_of(LUMI_COUNTS));
    for (const auto& row : bench["rows"])
        if (row["layout"] == "chord" && row["view"] == wanted.view && row["core"] == wanted.core &&
            row["texel"] == "rgb565" && row["mode"] == wanted.mode && row["span"] == wanted.span_px)
            return row["instructions_per_frame"];
    FAIL("the bench has no row of " << wanted.mode << ", " << wanted.view << ", " << wanted.core);
    return 0;
}

const bench::View& view_of(const std::string& name)
{
    return *std::find_if(
        std::begin(bench::kViews), std::end(bench::kViews), [&](const bench::View& view) { return view.name == name; });
}

PartRate rate_on(const char* part, const Field& field, Mode mode)
{
    for (const PartRate& rate : chord_rates(field, mode))
        if (rate.chip->key == std::string(part)) return rate;
    throw std::invalid_argument(part);
}

double rate_of(const char* part, const Field& field, Mode mode)
{
    return rate_on(part, field, mode).mean;
}

// The share of a frame's time in which a part waits for its cache.
double waiting_share(const char* part, const Field& field, Mode mode)
{
    const PartRate rate = rate_on(part, field, mode);
    return 1 - rate.mean / frames_per_second(*rate.chip, static_cast<uint64_t>(rate.instructions), 0);
}

}  // namespace

TEST_CASE("the planner's instructions of a frame are what the bench counted, in other views too")
{
    // docs/log/tradeoff.md has the worst errors.
    constexpr double kError = 0.1;
    const Opened opened(1024, 2048, TexelFormat::rgb565);
    const std::tuple<const char*, Mode, int> drawn[] = {{"nearest", Mode::nearest, 16},
                                                        {"nearest", Mode::nearest, 8},
                                                        {"linear", Mode::linear, 8},
                                                        {"paper", Mode::paper, 0},
                                                        {"linear", Mode::linear, 0}};
    for (const char* view : {"generic", "pole"}) {
        Camera camera;
        REQUIRE(make_view_camera(view_of(view), camera) == CameraError::none);
        for (const auto& [name, mode, span_px] : drawn) {
            const FrameWork work = frame_of(opened.field, mode, span_px, camera, 16).work;
            for (const char* core : {"m0plus", "m4"}) {
                INFO(core << " " << name << " " << span_px << " " << view);
                CHECK(instructions_of(core, work) == Approx(counted({core, view, name, span_px})).epsilon(kError));
            }
        }
    }
}

TEST_CASE("core counts each covered pixel of a chord field once, and where its texels are")
{
    const Opened opened(300, 400);
    for (const bench::View& view : bench::kViews) {
        Camera camera;
        REQUIRE(make_view_camera(view, camera) == CameraError::none);
        const FrameWork exact = frame_of(opened.field, Mode::nearest, 0, camera, 16).work;
        for (const int32_t span_px : {4, 8, 16}) {
            const ChordFrame spans = frame_of(opened.field, Mode::nearest, span_px, camera, 16);
            INFO(view.name << " " << span_px);
            CHECK(spans.work[Work::pixel] + spans.work[Work::checked_pixel] == exact[Work::exact]);
            CHECK(spans.work[Work::background] == exact[Work::background]);
            CHECK(spans.work[Work::checked_pixel] > spans.work[Work::polar_side]);
            CHECK(spans.reads.size() == exact[Work::exact]);
            for (const Read& read : spans.reads) REQUIRE(read.address < 300 * opened.field.row_stride_bytes);
        }
    }
}

TEST_CASE("a field that spans refuse has the rate of exact pixels, which is far below")
{
    // 56 × 56 rays, by counted instructions: 0.5 million clocks a scanline on an RP2040.
    const Opened refused(56, 56), taken(64, 64);
    CHECK_FALSE(is_drawn_by_spans(refused.field, Mode::linear, 8));
    CHECK(is_drawn_by_spans(taken.field, Mode::linear, 8));
    CHECK(rate_of("rp2040", refused.field, Mode::linear) < 0.1);
    CHECK(rate_of("rp2040", taken.field, Mode::linear) > 3);
}

TEST_CASE("a larger field misses more lines, and a dearer texel is slower")
{
    // Rates alone do not tell: of 100 points, more of a frame lies near poles and borders, which costs instructions.
    const Opened small(100, 100), large(2000, 3000);
    CHECK(waiting_share("rp2040", large.field, Mode::nearest) >
          2 * waiting_share("rp2040", small.field, Mode::nearest));
    const Opened grey(100, 100, TexelFormat::luma8);
    CHECK(rate_of("stm32f4", small.field, Mode::linear) < 0.9 * rate_of("stm32f4", grey.field, Mode::linear));
}

TEST_CASE("exact pixels of fewer points cost less where all of them are looked at")
{
    const Opened few(8, 8), more(63, 63);
    for (const ChordMode& mode : chord_modes())
        CHECK(rate_of("stm32f4", few.field, mode.mode) > 1.8 * rate_of("stm32f4", more.field, mode.mode));
}

TEST_CASE("cheaper modes of a field are faster, on every part, and no mode is faster than the display")
{
    const Opened opened(300, 400, TexelFormat::palette8);
    for (const Chip& chip : kChipList) {
        double before = chip.clock_mhz / 1000;  // the paper's, whose every pixel is exact
        for (const ChordMode& mode : chord_modes()) {
            const double rate = rate_of(chip.key, opened.field, mode.mode);
            CHECK(rate >= before);
            CHECK(rate < 67.9);
            before = rate;
        }
    }
}

}  // namespace lumi::planner
