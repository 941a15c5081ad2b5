/* SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "lvgl.h"

static lv_image_decoder_t decoder;

uint32_t lv_tick_get(void)
{
    return 0;
}

lv_image_decoder_t* lv_image_decoder_create(void)
{
    return &decoder;
}
void lv_image_decoder_set_info_cb(lv_image_decoder_t* to, lv_info_cb call)
{
    to->info = call;
}
void lv_image_decoder_set_open_cb(lv_image_decoder_t* to, lv_open_cb call)
{
    to->open = call;
}
void lv_image_decoder_set_get_area_cb(lv_image_decoder_t* to, lv_area_cb call)
{
    to->get_area = call;
}
void lv_image_decoder_set_close_cb(lv_image_decoder_t* to, lv_close_cb call)
{
    to->close = call;
}

static uint32_t stride_of(uint32_t w, uint32_t cf)
{
    return cf == LV_COLOR_FORMAT_RGB565A8 ? 2 * w : 4 * w;
}

static uint32_t size_of(uint32_t w, uint32_t h, uint32_t cf)
{
    const uint32_t stride = stride_of(w, cf);
    return cf == LV_COLOR_FORMAT_RGB565A8 ? stride * h + stride / 2 * h : stride * h;
}

lv_draw_buf_t* lv_draw_buf_create(uint32_t w, uint32_t h, uint32_t cf, uint32_t stride)
{
    lv_draw_buf_t* const made = calloc(1, sizeof *made);
    LV_UNUSED(stride);
    made->data_size = size_of(w, h, cf);
    made->data = malloc(made->data_size);
    return made;
}

lv_draw_buf_t* lv_draw_buf_reshape(lv_draw_buf_t* buffer, uint32_t cf, uint32_t w, uint32_t h, uint32_t stride)
{
    LV_UNUSED(stride);
    if (size_of(w, h, cf) > buffer->data_size) return NULL;
    buffer->header.w = w & 0xFFFF;
    buffer->header.h = h & 0xFFFF;
    buffer->header.stride = stride_of(w, cf) & 0xFFFF;
    return buffer;
}

void lv_draw_buf_destroy(lv_draw_buf_t* buffer)
{
    free(buffer->data);
    free(buffer);
}
