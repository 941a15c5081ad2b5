/* SPDX-License-Identifier: MIT
 * Stands for the parts of LVGL 9 that its image decoders see, so that ours is tested where LVGL is not. Names and types
 * are LVGL's; lvgl_double.c does what its functions promise. tools/lab/devices.sh --lvgl takes the true ones. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef LV_COLOR_DEPTH
#define LV_COLOR_DEPTH 16
#endif
#define LV_IMAGE_HEADER_MAGIC 0x19
#define LV_COORD_MIN (-(1 << 29))
#define LV_MIN(a, b) ((a) < (b) ? (a) : (b))
#define LV_UNUSED(x) ((void)(x))
#define LV_LOG_WARN(...) ((void)0)

typedef enum { LV_RESULT_INVALID = 0, LV_RESULT_OK } lv_result_t;
typedef enum { LV_IMAGE_SRC_VARIABLE, LV_IMAGE_SRC_FILE } lv_image_src_t;
enum { LV_COLOR_FORMAT_RAW_ALPHA = 2, LV_COLOR_FORMAT_ARGB8888 = 0x10, LV_COLOR_FORMAT_RGB565A8 = 0x14 };

typedef struct {
    int32_t x1, y1, x2, y2;
} lv_area_t;
typedef struct {
    uint32_t magic : 8, cf : 8, flags : 16;
    uint32_t w : 16, h : 16;
    uint32_t stride : 16, reserved : 16;
} lv_image_header_t;
typedef struct {
    lv_image_header_t header;
    uint32_t data_size;
    const uint8_t* data;
} lv_image_dsc_t;
typedef struct {
    lv_image_header_t header;
    uint32_t data_size;
    uint8_t* data;
} lv_draw_buf_t;

typedef struct lv_image_decoder lv_image_decoder_t;
typedef struct {
    const void* src;
    lv_image_src_t src_type;
    lv_image_header_t header;
    const lv_draw_buf_t* decoded;
    const char* error_msg;
    void* user_data;
} lv_image_decoder_dsc_t;

typedef lv_result_t (*lv_info_cb)(lv_image_decoder_t*, lv_image_decoder_dsc_t*, lv_image_header_t*);
typedef lv_result_t (*lv_open_cb)(lv_image_decoder_t*, lv_image_decoder_dsc_t*);
typedef lv_result_t (*lv_area_cb)(lv_image_decoder_t*, lv_image_decoder_dsc_t*, const lv_area_t*, lv_area_t*);
typedef void (*lv_close_cb)(lv_image_decoder_t*, lv_image_decoder_dsc_t*);
struct lv_image_decoder {
    lv_info_cb info;
    lv_open_cb open;
    lv_area_cb get_area;
    lv_close_cb close;
    const char* name;
};

uint32_t lv_tick_get(void);                        /* stands still */
lv_image_decoder_t* lv_image_decoder_create(void); /* there is one */
void lv_image_decoder_set_info_cb(lv_image_decoder_t*, lv_info_cb);
void lv_image_decoder_set_open_cb(lv_image_decoder_t*, lv_open_cb);
void lv_image_decoder_set_get_area_cb(lv_image_decoder_t*, lv_area_cb);
void lv_image_decoder_set_close_cb(lv_image_decoder_t*, lv_close_cb);
lv_draw_buf_t* lv_draw_buf_create(uint32_t w, uint32_t h, uint32_t cf, uint32_t stride);
lv_draw_buf_t* lv_draw_buf_reshape(lv_draw_buf_t*, uint32_t cf, uint32_t w, uint32_t h, uint32_t stride);
void lv_draw_buf_destroy(lv_draw_buf_t*);

#ifdef __cplusplus
}
#endif
