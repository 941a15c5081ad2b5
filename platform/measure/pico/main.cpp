// SPDX-License-Identifier: MIT
#include <hardware/clocks.h>
#include <lumi_measure.h>
#include <pico/stdlib.h>
#include <stdio.h>

#include "desk_clock.h"  // written by lumi_add_field

using Panel = lumi::Screen<240, 240, 16>;
static desk_clock_view<Panel> view;

static uint32_t now_us()
{
    return time_us_32();
}

static void print(const char* text)
{
    printf("%s", text);
}

int main()
{
    stdio_init_all();
    const measure::Board board = {PICO_BOARD, clock_get_hz(clk_sys) / 1000000, now_us, print};
    for (;; sleep_ms(5000)) measure::surface<Panel>(board, {"desk_clock", desk_clock, desk_clock_size()}, view);
}
