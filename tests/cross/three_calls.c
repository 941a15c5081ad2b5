/* SPDX-License-Identifier: MIT
 * A firmware in C that makes three calls of lumi.h, for a test of what it links. Never run. */
#include <lumi/lumi.h>

extern const uint8_t product[];
const uint8_t product[8] = {0};

static uint64_t memory[LUMI_MEMORY(100, 100, 48, 37, 8) / 8 + 1];
static uint8_t pixels[2 * 48 * 8];

int main(void)
{
    const lumi_screen screen = {48, 37, 8, LUMI_ANTIALIASED};
    const lumi_orbit orbit = {LUMI_DEGREES(30), LUMI_DEGREES(20), LUMI_RADII(3), LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
    const lumi_stripe stripe = {pixels, 0, 0, 48, 8, 96};
    lumi_view* view;
    lumi_error error = lumi_open(memory, sizeof memory, product, sizeof product, screen, &view);
    if (error == 0) error = lumi_look(view, orbit);
    return error == 0 ? lumi_draw(view, stripe) : error;
}
