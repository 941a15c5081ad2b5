// SPDX-License-Identifier: MIT
// This machine as a board: the display is a window, files, or both.
#include "board.h"

#include <lumi/host/png.h>
#include <lumi/pixel.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

#include "simulator.h"

namespace
{

using lumi::PixelRgb565Swapped;
using simulator::options;

std::vector<uint8_t> display;
size_t sent;
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
    const int width = options.width_px, height = options.height_px, side = std::min(width, height);
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
    file << lumi::host::png_bytes({options.width_px, options.height_px, rgb.data()});
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
bool turn()
{
    const bool is_test = options.drag_x != 0 || options.drag_y != 0;
    if (!options.window) {
        if (frame + 1 == board::kFrames) return false;
        current = board::view_of_frame(frame + 1);
        return true;
    }
    if (is_test && frame > 0) return false;
    if (is_test) simulator::drag(options.drag_x, options.drag_y);
    return simulator::wait_for_turn(current);
}

bool end_frame()
{
    if (sent != display.size()) fail("a frame has " + std::to_string(sent) + " bytes");
    if (options.is_round) cut_to_disc();
    if (!options.folder.empty()) write_frame();
    if (options.window) show_frame();
    return turn();
}

void begin()
{
    display.resize(size_t{PixelRgb565Swapped::kBytes} * static_cast<size_t>(options.width_px * options.height_px));
    if (options.window) simulator::open_window();
    current = board::view_of_frame(0);
}

}  // namespace

bool board::next_view(lumi::Orbit& orbit)
{
    if (frame < 0)
        begin();
    else if (!end_frame())
        return false;
    ++frame;
    sent = 0;
    if (options.window) frame_begin_ms = simulator::milliseconds();
    orbit = current;
    return true;
}

void board::send(const uint8_t* pixels, uint32_t bytes)
{
    if (bytes > display.size() - sent) fail("a frame has more bytes than the display");
    std::memcpy(display.data() + sent, pixels, bytes);
    sent += bytes;
}
