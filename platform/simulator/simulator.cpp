// SPDX-License-Identifier: MIT
// lumi_simulator [--frames FOLDER] [--drag X,Y] [--rate FPS] [--chip NAME] [--mask round] [--size WIDTHxHEIGHT]
// Runs the Pico's program on this machine. The mouse turns the object, its wheel zooms, Escape ends.
//   --frames FOLDER  writes what the display shows, FOLDER/frame-0.png and on; without --drag it opens no window
//   --drag X,Y       drags the mouse by so many pixels after the first frame, draws, and ends
//   --rate FPS       waits as long between frames as a chip of that rate would draw
//   --chip NAME      the same at the rate that `lumi inspect --screen` models for the field: rp2040, rp2350, stm32f4,
//   ...
//   --size 466x466   draws for a display of another size, one of those in sizes.cpp
//   --mask round     shows a round panel: pixels outside of its disc are grey
#include "simulator.h"

#include <cstdio>
#include <cstring>

int firmware_main();  // main() of platform/pico_st7789

namespace simulator
{

Options options;

namespace
{

// Modelled rates of named chips, for the field that the simulator draws.
struct Rate {
    const char* chip;
    double frames_per_second;
};
#include "rates.inc"

// Frames a second; 0 for a chip that nobody knows.
double rate_of(const char* chip)
{
    for (const Rate& rate : kRates)
        if (std::strcmp(rate.chip, chip) == 0) return rate.frames_per_second;
    return 0;
}

// "rp2040|rp2350|...".
std::string chip_names()
{
    std::string names;
    for (const Rate& rate : kRates) names += (names.empty() ? "" : "|") + std::string(rate.chip);
    return names;
}

bool parse(const char* name, const char* value)
{
    if (std::strcmp(name, "--frames") == 0) {
        options.folder = value;
        options.window = options.drag_x != 0 || options.drag_y != 0;
        return true;
    }
    if (std::strcmp(name, "--drag") == 0) {
        options.window = true;
        return std::sscanf(value, "%d,%d", &options.drag_x, &options.drag_y) == 2;
    }
    if (std::strcmp(name, "--mask") == 0) {
        options.is_round = true;
        return std::strcmp(value, "round") == 0;
    }
    if (std::strcmp(name, "--size") == 0) {
        options.sized_main = main_of_size(value);
        return options.sized_main != nullptr;
    }
    const bool is_chip = std::strcmp(name, "--chip") == 0;
    if (!is_chip && std::strcmp(name, "--rate") != 0) return false;
    options.rate = is_chip ? rate_of(value) : std::atof(value);
    return options.rate > 0;
}

}  // namespace
}  // namespace simulator

int main(int count, char** arguments)
{
    for (int k = 1; k < count; k += 2) {
        if (k + 1 < count && simulator::parse(arguments[k], arguments[k + 1])) continue;
        std::fprintf(stderr,
                     "lumi_simulator [--frames FOLDER] [--drag X,Y] [--rate FPS] [--chip %s] [--mask round] [--size "
                     "%s]; not \"%s %s\"\n",
                     simulator::chip_names().c_str(), simulator::size_names().c_str(), arguments[k],
                     k + 1 < count ? arguments[k + 1] : "");
        return 2;
    }
    return simulator::options.sized_main != nullptr ? simulator::options.sized_main() : firmware_main();
}
