// SPDX-License-Identifier: MIT
// Counts what the linked renderer costs, one line per view and span:
//     view generic span 16 covered 42272 instructions 2345678 setup 345678 stack 600 crc 1234abcd
// The field is loaded to the start of the board's PSRAM. Arguments: names of views (none: all), then
// the spans to draw with, pixels (none: 0). With `poses` FIRST END in place of views, a line for each of these poses
// and each span:
//     pose 17 span 8 covered 42272 instructions 2345678 crc 1234abcd
#include <cstdlib>
#include <cstring>

#include "instance.h"
#include "loaded_view.h"
#include "lumi/detail/crc32.h"
#include "lumi/mps2/meters.h"
#include "text_line.h"

namespace lumi::bench
{
namespace
{

using firmware::TextLine;

constexpr int32_t kStripeHeight = 16;  // as firmware does that feeds a panel from a small buffer
constexpr uint32_t kStrideBytes = kSidePx * PixelRgb565::kBytes;

uint8_t frame[kSidePx * kStrideBytes];

using Draw = RenderError (*)(const Field&, const Camera&, const Stripe&, int32_t);

// Instructions of a whole frame, to within two ticks of the counter. Not inlined: its frame counts as stack of the
// drawing.
__attribute__((noinline)) uint64_t count_frame(Draw draw_stripe, const Field& field, const Camera& camera,
                                               int32_t span_px)
{
    RenderError error = RenderError::none;
    const uint64_t begin = mps2::instructions();
    for (int32_t y = 0; y < kSidePx && error == RenderError::none; y += kStripeHeight) {
        const Stripe stripe = {
            frame + static_cast<uint32_t>(y) * kStrideBytes, 0, y, kSidePx, kStripeHeight, kStrideBytes};
        error = draw_stripe(field, camera, stripe, span_px);
    }
    const uint64_t count = mps2::instructions() - begin;
    return error == RenderError::none ? count : 0;
}

void report(const View& view, const Field& field, const Camera& camera, int32_t span_px)
{
    const uint64_t setup = count_frame(draw_setup_only, field, camera, span_px);
    mps2::StackMeter meter;
    meter.paint();
    const uint64_t instructions = count_frame(draw, field, camera, span_px);
    const uint32_t stack_bytes = meter.high_water_bytes();
    const uint32_t crc = detail::crc32(0, frame, sizeof(frame));
    TextLine line;
    line.text("view ").text(view.name).text(" span ").decimal(static_cast<uint32_t>(span_px));
    line.text(" covered ").decimal(covered_pixels(camera)).text(" instructions ").decimal(instructions);
    line.text(" setup ").decimal(setup).text(" stack ").decimal(stack_bytes);
    mps2::write(line.text(" crc ").hex32(crc).text("\n").c_str());
}

bool is_view(const char* word)
{
    for (const View& view : kViews)
        if (std::strcmp(view.name, word) == 0) return true;
    return false;
}

void report_views(const Field& field, const Words& names, int32_t span_px)
{
    for (const View& view : kViews) {
        Camera camera;
        if (names.contain(view.name) && make_view_camera(view, camera) == CameraError::none)
            report(view, field, camera, span_px);
    }
}

// The names of views come first, then spans.
void report_all(const Field& field, const Words& words)
{
    Words names = {words.begin, words.begin};
    while (names.end != words.end && is_view(*names.end)) ++names.end;
    if (names.end == words.end) report_views(field, names, 0);
    for (const char* const* span = names.end; span != words.end; ++span)
        report_views(field, names, static_cast<int32_t>(std::strtol(*span, nullptr, 10)));
}

void report_pose(uint32_t number, const Field& field, int32_t span_px)
{
    const PosedView view = posed_view(number);
    Camera camera;
    if (make_camera(view.pose, view.image, camera) != CameraError::none) return;
    TextLine line;
    line.text("pose ").decimal(number).text(" span ").decimal(static_cast<uint32_t>(span_px));
    line.text(" covered ").decimal(covered_pixels(camera)).text(" instructions ");
    line.decimal(count_frame(draw, field, camera, span_px));
    mps2::write(line.text(" crc ").hex32(detail::crc32(0, frame, sizeof(frame))).text("\n").c_str());
}

// The first pose, the one after the last, and spans.
void report_poses(const Field& field, const Words& words)
{
    const auto number = [](const char* word) { return static_cast<uint32_t>(std::strtol(word, nullptr, 10)); };
    for (const char* const* span = words.begin + 2; span != words.end; ++span)
        for (uint32_t k = number(words.begin[0]); k < number(words.begin[1]); ++k)
            report_pose(k, field, static_cast<int32_t>(number(*span)));
}

}  // namespace
}  // namespace lumi::bench

int main(int argc, char** argv)
{
    using namespace lumi;
    Field field;
    if (!bench::open_loaded(open_field, field)) return 1;
    mps2::start_instruction_counter();
    const bench::Words words = bench::words_of(argc, argv);
    if (words.end - words.begin > 2 && std::strcmp(*words.begin, "poses") == 0)
        bench::report_poses(field, {words.begin + 1, words.end});
    else
        bench::report_all(field, words);
    return 0;
}
