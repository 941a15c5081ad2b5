/* SPDX-License-Identifier: MIT
 * The short programs of core/README.md, each run once. */
#include <lumi/lumi.h>
#include <stdio.h>

#include "draw_grey4.h"
#include "look_as_held.h"
#include "look_next.h"
#include "product.h"

enum { SIDE = 64 };

static uint64_t memory[LUMI_MEMORY_TWO_BY_TWO(product_vertices, product_patches, SIDE, SIDE, SIDE) / 8 + 1];
static uint8_t pixels[SIDE * SIDE];

int main(void)
{
    const lumi_screen screen = {SIDE, SIDE, SIDE, LUMI_TWO_BY_TWO};
    const lumi_stripe stripe = {pixels, 0, 0, SIDE, SIDE, SIDE};
    const lumi_quaternion turn = {9000, -4000, 11000, 2500};
    const lumi_touch touch = {true, 10, 10};
    lumi_view* view;
    lumi_error error = lumi_open(memory, sizeof memory, product, product_size(), screen, &view);
    if (error == 0) error = start(view);
    if (error == 0) error = look_as_held(view, turn);
    if (error == 0) error = draw_grey4(view, stripe);
    if (error == 0 && !look_next(view, touch, 16, 0)) return 1;
    if (error == 0) error = draw_grey4(view, stripe);
    fputs(error == 0 ? "" : lumi_error_text(error), stderr);
    return error;
}
