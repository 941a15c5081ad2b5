// SPDX-License-Identifier: MIT
// Game Boy Advance. The display is the video memory of mode 3. Reports go to mGBA's debug log, which a console lacks.
#include "board.h"

#include "start.h"
#include "text_line.h"

namespace
{

volatile uint16_t& at(uint32_t address)
{
    return *reinterpret_cast<volatile uint16_t*>(address);
}

volatile uint32_t& word_at(uint32_t address)
{
    return *reinterpret_cast<volatile uint32_t*>(address);
}

constexpr uint32_t kDisplay = 0x04000000, kScanline = 0x04000006, kDma3 = 0x040000D4, kTimer0 = 0x04000100,
                   kTimer1 = 0x04000104, kKeys = 0x04000130, kWaitStates = 0x04000204, kVideo = 0x06000000;
constexpr int32_t kHeight = 160;

// Two timers in a row count clocks in 32 bits.
void start_clock()
{
    constexpr uint16_t kOn = 0x80, kCascade = 4;
    at(kTimer1 + 2) = kOn | kCascade;
    at(kTimer0 + 2) = kOn;
}

uint32_t clocks()
{
    uint16_t high, low;
    do {
        high = at(kTimer1);
        low = at(kTimer0);
    } while (high != at(kTimer1));
    return static_cast<uint32_t>(high) << 16 | low;
}

// mGBA's debug log: its key opens it, then a text, then a level that sends it.
constexpr uint32_t kLogKey = 0x04FFF780, kLogText = 0x04FFF600, kLogSend = 0x04FFF700;

bool has_log()
{
    at(kLogKey) = 0xC0DE;
    return at(kLogKey) == 0x1DEA;
}

void write(const char* text)
{
    if (!has_log()) return;
    volatile char* out = reinterpret_cast<volatile char*>(kLogText);
    for (; *text != '\0'; ++text) *out++ = *text;
    *out = '\0';
    at(kLogSend) = 0x103;  // information
}

void wait_for_picture()  // until the whole video memory has been shown
{
    for (int k = 0; k < 2; ++k) {
        while (at(kScanline) == kHeight) {
        }
        while (at(kScanline) != kHeight) {
        }
    }
}

int frame = -1;
uint32_t begin, in_display;
uint8_t* video;
lumi::Orbit current;

void end_frame()
{
    const uint32_t spent = clocks() - begin;
    if (!has_log()) return;
    wait_for_picture();
    lumi::firmware::TextLine line;
    line.text("frame ").decimal(static_cast<uint32_t>(frame)).text(" cycles ").decimal(spent).text(" display ");
    line.decimal(in_display).text(" stack ").decimal(used_stack_bytes());
    line.text(" azimuth ").decimal(current.azimuth_turns32).text(" elevation ").decimal(current.elevation_turns32);
    write(line.c_str());
}

// 5 degrees for each key that is held.
void turn(lumi::Orbit& orbit)
{
    enum Key : uint32_t { kRight = 1 << 4, kLeft = 1 << 5, kUp = 1 << 6, kDown = 1 << 7 };
    const uint32_t held = ~static_cast<uint32_t>(at(kKeys));
    const auto step = [&](Key plus, Key minus) {
        return lumi::degrees(5 * (((held & plus) != 0) - ((held & minus) != 0)));
    };
    orbit.azimuth_turns32 += step(kRight, kLeft);
    const int32_t elevation = static_cast<int32_t>(orbit.elevation_turns32 + step(kUp, kDown));
    if (elevation <= static_cast<int32_t>(lumi::degrees(85)) && elevation >= static_cast<int32_t>(lumi::degrees(-85)))
        orbit.elevation_turns32 = static_cast<uint32_t>(elevation);
}

}  // namespace

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame < 0) {
        at(kWaitStates) = 0x4317;  // 3 and 1 clocks to the cartridge, and its prefetch
        at(kDisplay) = 0x0403;     // mode 3, background 2
        start_clock();
        current = view_of_frame(0);
    } else {
        end_frame();
        turn(current);
    }
    ++frame;
    video = reinterpret_cast<uint8_t*>(kVideo);
    orbit = current;
    in_display = 0;
    begin = clocks();
    return true;
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    constexpr uint32_t kWords = 1u << 26, kOn = 1u << 31;
    const uint32_t from = clocks();
    word_at(kDma3) = reinterpret_cast<uint32_t>(pixels);
    word_at(kDma3 + 4) = reinterpret_cast<uint32_t>(video);
    word_at(kDma3 + 8) = kOn | kWords | bytes / 4;  // the CPU waits
    video += bytes;
    in_display += clocks() - from;
}

extern "C" void board_stop(int code)
{
    lumi::firmware::TextLine line;
    write(line.text("exit ").decimal(static_cast<uint32_t>(code)).c_str());
    for (;;) {
    }
}
