// SPDX-License-Identifier: MIT
// Raspberry Pi Pico. After a frame a line goes to UART0.
#include "board.h"

#include "report.h"
#include "rp2040.h"
#include "st7789.h"
#include "start.h"
#include "text_line.h"

namespace
{

int frame = -1;
uint32_t begin;

void end_frame()
{
    st7789::wait();
    const uint32_t spent = rp2040::microseconds() - begin;
    lumi::firmware::TextLine line;
    line.text("frame ").decimal(static_cast<uint32_t>(frame)).text(" microseconds ").decimal(spent);
    line.text(" stack ").decimal(used_stack_bytes());
    add_report(line);
    rp2040::write(line.text("\n").c_str());
}

}  // namespace

__attribute__((weak)) void add_report(lumi::firmware::TextLine&) {}

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame < 0) {
        rp2040::start_clocks();
        st7789::start();
    } else {
        end_frame();
    }
    if (++frame == kFrames) return false;
    orbit = view_of_frame(frame);
    begin = rp2040::microseconds();
    st7789::begin_picture();
    return true;
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    st7789::send(pixels, bytes);
}

extern "C" void board_stop(int code)
{
    lumi::firmware::TextLine line;
    rp2040::write(line.text("exit ").decimal(static_cast<uint32_t>(code)).text("\n").c_str());
    for (;;) {
    }
}
