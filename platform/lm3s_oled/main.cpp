// SPDX-License-Identifier: MIT
// Draws the desk clock from flash in greys, stripe by stripe, and packs two pixels into a byte as the OLED takes them.
#include <lumi/pack.h>
#include <lumi/view.h>

#include "board.h"
#include "desk_clock.h"  // written by lumi_add_field

using namespace lumi;
using namespace lumi::detail;

static desk_clock_view<Screen<128, 64, 16, PixelGrey8>> view;
static uint8_t pixels[128 * 16];

int main()
{
    Orbit orbit;
    if (view.open(desk_clock, desk_clock_size()) != ViewError::none) return 1;
    while (board::next_view(orbit)) {
        if (view.look(orbit) != ViewError::none) return 1;
        for (int32_t y = 0; y < 64; y += 16) {
            const Stripe stripe = {pixels, 0, y, 128, 16, 128};
            if (view.draw(stripe) != ViewError::none) return 1;
            pack_grey4(stripe, pixels, grey4_bytes(128));
            board::send(pixels, 16 * grey4_bytes(128));
        }
    }
    return 0;
}
