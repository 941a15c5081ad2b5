/* SPDX-License-Identifier: MIT
 * lumi_lvgl_clock
 * A clock that shows the time by moving parts: each second LVGL redraws what has changed, and no more. Prints the
 * pixels of each tick; fails where the screen is not the one that a whole redraw gives. */
#include <stdio.h>

#include "headless.h"
#include "lv_lumi.h"
#include "running_clock.h" /* written by lumi_add_field */

enum { SIDE = 232, ROWS = 16, FIRST_SECOND = 36537 /* 10:08:57 */, SECONDS = 6 };

static uint64_t
    memory[(LUMI_MEMORY(running_clock_vertices, running_clock_patches, SIDE, SIDE, ROWS) +
            LUMI_SEE_THROUGH_MEMORY(running_clock_see_through) + LUMI_PARTS_MEMORY(running_clock_moving_parts) +
            LUMI_GLOSS_MEMORY(running_clock_gloss, running_clock_viewed)) /
               8 +
           1];
static lv_lumi_image_t image;

static lumi_error turn(uint32_t hand, uint32_t seconds, uint32_t seconds_a_turn)
{
    return lumi_turn(image.view, hand, (uint32_t)(((uint64_t)(seconds % seconds_a_turn) << 32) / seconds_a_turn));
}

static bool show(lv_obj_t* clock, uint32_t second)
{
    if (turn(running_clock_part_second_hand, second, 60) != 0) return false;
    if (turn(running_clock_part_minute_hand, second / 10 * 10, 60 * 60) != 0) return false;
    if (turn(running_clock_part_hour_hand, second / 60 * 60, 12 * 60 * 60) != 0) return false;
    return lv_lumi_show_parts(clock) == 0;
}

/* Whether a redraw of all changes nothing on the screen. */
static bool is_whole(lv_obj_t* clock)
{
    const uint32_t before = headless_checksum();
    lv_obj_invalidate(clock);
    headless_run(100);
    return headless_checksum() == before;
}

int main(void)
{
    const lumi_screen screen = {SIDE, SIDE, ROWS, LUMI_ANTIALIASED};
    const lumi_orbit orbit = {LUMI_DEGREES(30), LUMI_DEGREES(20), LUMI_RADII(3), LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
    headless_start();
    lv_lumi_image_decoder_init();
    if (lv_lumi_image_open(&image, memory, sizeof memory, running_clock, running_clock_size(), screen) != 0) return 1;
    lv_obj_t* const clock = lv_lumi_create(lv_screen_active(), &image);
    lv_obj_center(clock);
    lv_lumi_set_orbit(clock, orbit);
    for (uint32_t second = FIRST_SECOND; second < FIRST_SECOND + SECONDS; ++second) {
        const uint32_t sent = headless_pixels();
        if (!show(clock, second)) return 1;
        headless_run(100);
        printf("second %lu pixels %lu\n", (unsigned long)second, (unsigned long)(headless_pixels() - sent));
        if (image.error != 0 || !is_whole(clock)) return 1;
    }
    return 0;
}
