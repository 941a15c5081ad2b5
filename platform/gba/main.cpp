// SPDX-License-Identifier: MIT
// Draws the desk clock from the cartridge, stripe by stripe, in video mode 3. The key pad turns it.
#include <lumi/view.h>

#include "board.h"
#include "desk_clock.h"  // written by lumi_add_field

using namespace lumi;
using namespace lumi::detail;

using ClockView = desk_clock_view<SharedSamples<Screen<240, 160, 5, PixelBgr555>>>;
static ClockView view;
__attribute__((section(".fast"))) static ClockView::Samples samples;  // these, and the code that fills them
alignas(4) static uint8_t stripe[240 * 5 * 2];

int main()
{
    Orbit orbit;
    if (view.open(desk_clock, desk_clock_size()) != ViewError::none) return 1;
    while (board::next_view(orbit)) {
        if (view.look(orbit) != ViewError::none) return 1;
        for (int32_t y = 0; y < 160; y += 5) {
            if (view.draw({stripe, 0, y, 240, 5, 480}, OverBlack{}, samples) != ViewError::none) return 1;
            board::send(stripe, sizeof(stripe));
        }
    }
    return 0;
}
