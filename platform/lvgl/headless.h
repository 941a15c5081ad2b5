/* SPDX-License-Identifier: MIT
 * A display of LVGL in memory, a finger that follows a script, and a clock that this program turns. */
#ifndef HEADLESS_H
#define HEADLESS_H

#include <lvgl.h>

enum { HEADLESS_WIDTH = 320, HEADLESS_HEIGHT = 240, HEADLESS_BUFFER_ROWS = 24 };

/* Starts LVGL with that display, in partial buffers. */
void headless_start(void);
/* Lets LVGL work for so long. */
void headless_run(uint32_t milliseconds);
/* Drags the finger from one point to another in 200 ms, and holds it there as long before it is let go. */
void headless_drag(lv_point_t from, lv_point_t to);
/* Turns the wheel of the pointer, which stays where it was let go. */
void headless_wheel(int steps);
/* Writes RGB565, low byte first, row by row. */
int headless_write(const char* path);
/* Parts of the screen that LVGL sent since the start. */
uint32_t headless_flushes(void);
/* Pixels of these parts. */
uint32_t headless_pixels(void);
/* Of what the screen shows. */
uint32_t headless_checksum(void);

#endif
