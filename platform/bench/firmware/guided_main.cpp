// SPDX-License-Identifier: MIT
// Counts what the linked guided renderer costs, one line per view, as main.cpp writes them:
//     view generic span 0 covered 42272 instructions 2345678 setup 345678 stack 600 crc 1234abcd
// Set-up is all that finds the surface: the frame's proxy, its depths, every pixel's point. The field is loaded to the
// start of the board's PSRAM. Arguments: names of views (none: all).
#include "guided_instance.h"
#include "loaded_view.h"
#include "lumi/crc32.h"
#include "lumi/mps2/instruction_counter.h"
#include "lumi/mps2/stack_meter.h"
#include "text_line.h"

namespace lumi::bench
{
namespace
{

using firmware::TextLine;
uint8_t frame_pixels[kSidePx * kGuidedStrideBytes];

bool report(const View& view, const GuidedField& field)
{
    GuidedCamera camera;
    if (make_guided_camera(view_pose(view), view_image(view), camera) != CameraError::none) return false;
    const uint64_t begin = mps2::instructions();
    find_guided_surface(field, camera);
    const uint64_t setup = mps2::instructions() - begin;
    mps2::StackMeter meter;
    meter.paint();
    const uint64_t drawing = mps2::instructions();
    if (!draw_guided(field, camera, frame_pixels)) return false;
    const uint64_t instructions = mps2::instructions() - drawing;
    const uint32_t stack_bytes = meter.high_water_bytes();
    TextLine line;
    line.text("view ").text(view.name).text(" span 0 covered ").decimal(covered_pixels(camera.camera));
    line.text(" instructions ").decimal(instructions).text(" setup ").decimal(setup);
    line.text(" stack ").decimal(stack_bytes);
    mps2::write(line.text(" crc ").hex32(crc32(0, frame_pixels, sizeof(frame_pixels))).text("\n").c_str());
    return true;
}

}  // namespace
}  // namespace lumi::bench

int main(int argc, char** argv)
{
    using namespace lumi;
    GuidedField field;
    if (!bench::open_loaded(open_guided, field)) return 1;
    mps2::start_instruction_counter();
    const bench::Words names = bench::words_of(argc, argv);
    for (const bench::View& view : bench::kViews)
        if (names.contain(view.name) && !bench::report(view, field)) return 1;
    return 0;
}
