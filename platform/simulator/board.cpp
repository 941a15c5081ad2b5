// SPDX-License-Identifier: MIT
// This machine as a board: the display is a window, files, or both.
#include "board.h"

#include <lumi/host/png.h>
#include <lumi/pixel.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <vector>

#include "simulator.h"

namespace
{

using lumi::PixelRgb565Swapped;
using simulator::kHeightPx;
using simulator::kWidthPx;
using simulator::options;

std::vector<uint8_t> display;
lumi::PixelRect target;  // of what is sent
size_t sent, expected;   // bytes of the target
uint32_t frame_begin_ms;
int frame = -1;
lumi::Orbit current;

[[noreturn]] void fail(const std::string& what)
{
    std::fprintf(stderr, "lumi_simulator: %s\n", what.c_str());
    std::exit(1);
}

// A round panel has no pixels outside of the disc that its square holds; here they are grey.
void cut_to_disc()
{
    constexpr lumi::Rgb8 kBezel = {32, 32, 32};
    const int width = kWidthPx, height = kHeightPx, side = std::min(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int right = 2 * x + 1 - width, down = 2 * y + 1 - height;  // of the centre, in half pixels
            if (right * right + down * down > side * side)
                PixelRgb565Swapped::store(display.data() + 2 * (y * width + x), kBezel);
        }
}

void write_frame()
{
    std::vector<uint8_t> rgb(display.size() / 2 * 3);
    for (size_t k = 0; k < display.size() / 2; ++k)
        lumi::PixelRgb888::store(rgb.data() + 3 * k, PixelRgb565Swapped::load(display.data() + 2 * k));
    const std::string path = options.folder + "/frame-" + std::to_string(frame) + ".png";
    std::ofstream file(path, std::ios::binary);
    file << lumi::host::png_bytes({kWidthPx, kHeightPx, rgb.data()});
    if (!file.flush()) fail(path + " cannot be written");
}

void show_frame()
{
    std::vector<uint16_t> native(display.size() / 2);
    for (size_t k = 0; k < native.size(); ++k)
        native[k] = static_cast<uint16_t>(display[2 * k] << 8 | display[2 * k + 1]);
    const uint32_t wanted = options.rate > 0 ? static_cast<uint32_t>(1000 / options.rate) : 0;
    const uint32_t spent = simulator::milliseconds() - frame_begin_ms;
    if (spent < wanted) simulator::wait_milliseconds(wanted - spent);
    simulator::show(native.data());
}

// The next view; false: that was the last.
bool turn(int most_ms = -1)
{
    const bool is_test = options.drag_x != 0 || options.drag_y != 0;
    if (!options.window) {
        if (frame + 1 == board::kFrames) return false;
        current = board::view_of_frame(frame + 1);
        return true;
    }
    if (is_test && frame > 0) return false;
    if (is_test) simulator::drag(options.drag_x, options.drag_y);
    return simulator::wait_for_turn(current, most_ms);
}

void check_sent()
{
    if (sent != expected) fail("of " + std::to_string(expected) + " bytes " + std::to_string(sent) + " were sent");
}

void end_frame()
{
    check_sent();
    if (options.is_round) cut_to_disc();
    if (!options.folder.empty()) write_frame();
    if (options.window) show_frame();
}

void begin()
{
    display.resize(size_t{PixelRgb565Swapped::kBytes} * size_t{kWidthPx * kHeightPx});
    if (options.window) simulator::open_window();
    current = board::view_of_frame(0);
}

void begin_frame(lumi::Orbit& orbit)
{
    ++frame;
    sent = expected = 0;
    if (options.window) frame_begin_ms = simulator::milliseconds();
    orbit = current;
}

// The computer's clock says this second, and another one after so many milliseconds.
struct Now {
    uint32_t second;
    int left_ms;
};
Now now()
{
    timespec time = {};
    timespec_get(&time, TIME_UTC);
    const tm local = *std::localtime(&time.tv_sec);
    return {static_cast<uint32_t>((local.tm_hour * 60 + local.tm_min) * 60 + local.tm_sec),
            static_cast<int>(1000 - time.tv_nsec / 1000000)};
}

}  // namespace

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame < 0)
        begin();
    else if (end_frame(); !turn())
        return false;
    begin_frame(orbit);
    set_window({0, 0, kWidthPx, kHeightPx});
    return true;
}

bool board::next_second(lumi::Orbit& orbit, uint32_t& second)
{
    if (frame < 0)
        begin();
    else if (end_frame(); !turn(now().left_ms))
        return false;
    if (!options.window) current = view_of_frame(0);
    begin_frame(orbit);
    second = options.window ? now().second : kFirstSecond + static_cast<uint32_t>(frame);
    return true;
}

void board::set_window(const lumi::PixelRect& window)
{
    check_sent();
    target = window;
    sent = 0;
    expected = size_t{PixelRgb565Swapped::kBytes} * static_cast<size_t>(window.width_px * window.height_px);
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    if (bytes > expected - sent) fail("more bytes were sent than a rectangle has");
    const size_t row = size_t{PixelRgb565Swapped::kBytes} * static_cast<size_t>(target.width_px);
    for (const uint8_t* const end = pixels + bytes; pixels != end;) {
        const size_t run = std::min(row - sent % row, static_cast<size_t>(end - pixels));
        const size_t first = static_cast<size_t>(target.y_px) + sent / row;
        std::memcpy(display.data() +
                        (first * size_t{kWidthPx} + static_cast<size_t>(target.x_px)) * PixelRgb565Swapped::kBytes +
                        sent % row,
                    pixels, run);
        pixels += run;
        sent += run;
    }
}
