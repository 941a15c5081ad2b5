// SPDX-License-Identifier: MIT
// Draws the desk clock from flash, stripe by stripe, and hands each to the display.
#include <lumi/view.h>

#include "board.h"
#include "desk_clock.h"  // written by lumi_add_field

using namespace lumi;
using namespace lumi::detail;

static desk_clock_view<Screen<240, 240, 16>> view;
alignas(4) static uint8_t stripe[240 * 16 * 2];

int main()
{
    Orbit orbit;
    if (view.open(desk_clock, desk_clock_size()) != ViewError::none) return 1;
    while (board::next_view(orbit)) {
        if (view.look(orbit) != ViewError::none) return 1;
        for (int32_t y = 0; y < 240; y += 16) {
            if (view.draw({stripe, 0, y, 240, 16, 480}) != ViewError::none) return 1;
            board::send(stripe, sizeof(stripe));
        }
    }
    return 0;
}
