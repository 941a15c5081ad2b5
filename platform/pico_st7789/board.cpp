// SPDX-License-Identifier: MIT
// Raspberry Pi Pico with an ST7789 of 240 × 240 pixels. After a frame a line goes to UART0.
#include "board.h"

#include "bus.h"
#include "core1.h"
#include "rp2040.h"
#include "text_line.h"

namespace
{

void command(uint8_t code)
{
    bus::wait();
    bus::take_command();
    bus::put(code);
    bus::wait();
    bus::take_data();
}

enum Command : uint8_t {
    kSoftwareReset = 0x01,
    kSleepOut = 0x11,
    kInvert = 0x21,  // these panels are made inverted
    kDisplayOn = 0x29,
    kColumns = 0x2A,
    kRows = 0x2B,
    kWritePixels = 0x2C,
    kScanOrder = 0x36,
    kPixelFormat = 0x3A,
};

void command(Command code, uint8_t value)
{
    command(code);
    bus::put(value);
}

void set_range(Command code, int32_t first, int32_t count)
{
    const uint8_t bytes[] = {0, static_cast<uint8_t>(first), 0, static_cast<uint8_t>(first + count - 1)};
    command(code);
    for (const uint8_t byte : bytes) bus::put(byte);
}

void start_panel()
{
    constexpr uint32_t kAfterReset = 120000, kAfterSleep = 5000;  // microseconds, of the controller's datasheet
    bus::start();
    command(kSoftwareReset);
    bus::wait();
    rp2040::wait_microseconds(kAfterReset);
    command(kSleepOut);
    rp2040::wait_microseconds(kAfterSleep);
    command(kPixelFormat, 0x55);  // 16 bits
    command(kScanOrder, 0);
    command(kInvert);
    set_range(kColumns, 0, 240);
    set_range(kRows, 0, 240);
    command(kDisplayOn);
}

int frame = -1;
uint32_t begin_us, sent_bytes;

void begin_frame()
{
    begin_us = rp2040::microseconds();
    sent_bytes = 0;
}

void end_frame()
{
    bus::wait();
    const uint32_t spent = rp2040::microseconds() - begin_us;
    lumi::firmware::TextLine line;
    line.text("frame ").decimal(static_cast<uint32_t>(frame)).text(" microseconds ").decimal(spent);
    line.text(" stack ").decimal(used_stack_bytes());
    line.text(" bytes ").decimal(sent_bytes);
    add_report(line);
    rp2040::write(line.text("\n").c_str());
}

void start_or_end_frame()
{
    if (frame >= 0) return end_frame();
    rp2040::start_clocks();
    start_panel();
}

}  // namespace

__attribute__((weak)) void add_report(lumi::firmware::TextLine&) {}

bool board::next_view(lumi::Orbit& orbit)
{
    start_or_end_frame();
    if (++frame == kFrames) return false;
    orbit = view_of_frame(frame);
    begin_frame();
    command(kWritePixels);
    return true;
}

bool board::next_second(lumi::Orbit& orbit, uint32_t& second)
{
    constexpr uint32_t kSecond = 1000000;
    static uint32_t due_us;
    start_or_end_frame();
    due_us = ++frame == 0 ? rp2040::microseconds() : due_us + kSecond;
    const auto early_us = static_cast<int32_t>(due_us - rp2040::microseconds());
    if (early_us > 0) rp2040::wait_microseconds(static_cast<uint32_t>(early_us));
    orbit = view_of_frame(0);
    second = kFirstSecond + static_cast<uint32_t>(frame);
    begin_frame();
    return true;
}

void board::set_window(const lumi::PixelRect& window)
{
    set_range(kColumns, window.x_px, window.width_px);
    set_range(kRows, window.y_px, window.height_px);
    command(kWritePixels);
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    sent_bytes += bytes;
    bus::send(pixels, bytes);
}

extern "C" void board_stop(int code)
{
    lumi::firmware::TextLine line;
    rp2040::write(line.text("exit ").decimal(static_cast<uint32_t>(code)).text("\n").c_str());
    for (;;) {
    }
}
