// SPDX-License-Identifier: MIT
// lumi_simulator [--frames FOLDER] [--drag X,Y] [--rate FPS] [--mask round]
// Runs the Pico's program on this machine. The mouse turns the object, its wheel zooms, Escape ends.
//   --frames FOLDER  writes what the display shows, FOLDER/frame-0.png and on; without --drag it opens no window
//   --drag X,Y       drags the mouse by so many pixels after the first frame, draws, and ends
//   --rate FPS       waits as long between frames as a chip of that rate would draw
//   --mask round     shows a round panel: pixels outside of its disc are grey
#include "simulator.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

int firmware_main();  // main() of platform/pico_st7789

namespace simulator
{

Options options;

namespace
{

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
    if (std::strcmp(name, "--rate") != 0) return false;
    options.rate = std::atof(value);
    return options.rate > 0;
}

}  // namespace
}  // namespace simulator

int main(int count, char** arguments)
{
    for (int k = 1; k < count; k += 2) {
        if (k + 1 < count && simulator::parse(arguments[k], arguments[k + 1])) continue;
        std::fprintf(stderr,
                     "lumi_simulator [--frames FOLDER] [--drag X,Y] [--rate FPS] [--mask round]; not \"%s %s\"\n",
                     arguments[k], k + 1 < count ? arguments[k + 1] : "");
        return 2;
    }
    return firmware_main();
}
