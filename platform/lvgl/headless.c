/* SPDX-License-Identifier: MIT */
#include "headless.h"

#include <stdio.h>
#include <string.h>

enum { PIXEL_BYTES = 2, STEP_MS = 5, DRAG_STEPS = 40 };

static uint8_t screen[HEADLESS_HEIGHT][HEADLESS_WIDTH * PIXEL_BYTES];
static uint32_t now_ms, flushes, pixels_sent;
static lv_indev_state_t finger_state = LV_INDEV_STATE_RELEASED;
static lv_point_t finger;
static int16_t wheel;

static uint32_t now(void)
{
    return now_ms;
}

static void flush(lv_display_t* display, const lv_area_t* area, uint8_t* pixels)
{
    const size_t bytes = (size_t)lv_area_get_width(area) * PIXEL_BYTES;
    const uint32_t stride = lv_draw_buf_width_to_stride((uint32_t)lv_area_get_width(area), LV_COLOR_FORMAT_RGB565);
    for (int32_t y = area->y1; y <= area->y2; ++y, pixels += stride)
        memcpy(&screen[y][area->x1 * PIXEL_BYTES], pixels, bytes);
    ++flushes;
    pixels_sent += lv_area_get_size(area);
    lv_display_flush_ready(display);
}

static void read_finger(lv_indev_t* indev, lv_indev_data_t* data)
{
    LV_UNUSED(indev);
    data->state = finger_state;
    data->point = finger;
    data->enc_diff = wheel;
    wheel = 0;
}

void headless_start(void)
{
    static LV_ATTRIBUTE_MEM_ALIGN uint8_t buffers[2][HEADLESS_WIDTH * HEADLESS_BUFFER_ROWS * PIXEL_BYTES];
    lv_init();
    lv_tick_set_cb(now);
    lv_display_t* const display = lv_display_create(HEADLESS_WIDTH, HEADLESS_HEIGHT);
    lv_display_set_flush_cb(display, flush);
    lv_display_set_buffers(display, buffers[0], buffers[1], sizeof buffers[0], LV_DISPLAY_RENDER_MODE_PARTIAL);
    lv_indev_t* const indev = lv_indev_create();
    lv_indev_set_type(indev, LV_INDEV_TYPE_POINTER);
    lv_indev_set_read_cb(indev, read_finger);
}

void headless_run(uint32_t milliseconds)
{
    for (uint32_t spent = 0; spent < milliseconds; spent += STEP_MS) {
        now_ms += STEP_MS;
        lv_timer_handler();
    }
}

void headless_drag(lv_point_t from, lv_point_t to)
{
    finger_state = LV_INDEV_STATE_PRESSED;
    for (int32_t k = 0; k <= DRAG_STEPS; ++k) {
        finger.x = from.x + (to.x - from.x) * k / DRAG_STEPS;
        finger.y = from.y + (to.y - from.y) * k / DRAG_STEPS;
        headless_run(STEP_MS);
    }
    headless_run(DRAG_STEPS * STEP_MS);
    finger_state = LV_INDEV_STATE_RELEASED;
    headless_run(2 * STEP_MS);
}

void headless_wheel(int steps)
{
    wheel = (int16_t)steps;
    headless_run(100);
}

int headless_write(const char* path)
{
    FILE* const file = fopen(path, "wb");
    if (file == NULL) return 1;
    const size_t written = fwrite(screen, sizeof screen, 1, file);
    return fclose(file) != 0 || written != 1;
}

uint32_t headless_flushes(void)
{
    return flushes;
}

uint32_t headless_pixels(void)
{
    return pixels_sent;
}

/* FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv/. */
uint32_t headless_checksum(void)
{
    uint32_t hash = 2166136261u;
    for (const uint8_t* at = screen[0]; at != screen[0] + sizeof screen; ++at) hash = (hash ^ *at) * 16777619u;
    return hash;
}
