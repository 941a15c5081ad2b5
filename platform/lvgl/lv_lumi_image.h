/* SPDX-License-Identifier: MIT
 * A surface field as an image of LVGL 9.3 and later. No picture of it lies in memory: when LVGL draws a part of the
 * screen, the decoder draws that part of the object, some rows at a time, with coverage, so it may lie over and under
 * other widgets. Whatever rectangle LVGL redraws, it gets the pixels that the whole frame has there.
 *
 *     static lv_lumi_image_t product_image;
 *     lv_lumi_image_decoder_init();                       once, after lv_init()
 *     lv_lumi_image_open(&product_image, memory, sizeof memory, product, product_size(), screen);
 *     lv_image_set_src(image, &product_image);            or lv_lumi_create (lv_lumi.h)
 *     lv_lumi_image_set_orbit(&product_image, orbit);     then lv_obj_invalidate(image)
 *
 * Displays of LV_COLOR_DEPTH 16 get RGB565A8, others ARGB8888. Link lv_lumi_renderer.cpp, which is lumi.h's renderer
 * for these pixels. Where LVGL draws by several threads (LV_DRAW_SW_DRAW_UNIT_CNT), an image is for one widget. */
#ifndef LV_LUMI_IMAGE_H
#define LV_LUMI_IMAGE_H

#include <lumi/lumi.h>
#include <lvgl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Stays where it is as long as a widget shows it. Its parts are for reading. */
typedef struct {
    lv_image_dsc_t source; /* what LVGL knows it by: `data` is this struct */
    lumi_view* view;
    lumi_screen screen;
    lumi_orbit orbit;
    uint8_t mode;     /* of the next frame: at first the screen's, which is the finest */
    bool is_turned;   /* since the view was last prepared */
    bool is_drawn;    /* some of the frame that was asked for last, or that failed */
    lumi_error error; /* what the last drawing returned */
    /* Counts what drawing this frame has taken so far, with LVGL's work on its pixels, in the unit of the clock. */
    uint32_t spent, began;
    uint32_t (*clock)(void);
} lv_lumi_image_t;

/* Tells LVGL how to draw these images. */
void lv_lumi_image_decoder_init(void);

/* The memory is lumi_open's, and stays as long as the image is used. The screen is the image's size; LVGL's own memory
 * gives screen.rows_px rows of pixels while it draws. The eye is 3 radii away, at azimuth and elevation 0. */
lumi_error lv_lumi_image_open(lv_lumi_image_t* image, void* memory, size_t memory_bytes, const uint8_t* field,
                              size_t field_bytes, lumi_screen screen);

/* The next frame's eye. Costs nothing until LVGL draws the image. */
void lv_lumi_image_set_orbit(lv_lumi_image_t* image, lumi_orbit orbit);
/* The next frame's mode, none finer than the screen's; a finer one is an error when LVGL draws. */
void lv_lumi_image_set_mode(lv_lumi_image_t* image, uint8_t mode);
/* A clock measures frames: a counter that runs upwards and wraps. At first lv_tick_get, in milliseconds. */
void lv_lumi_image_set_clock(lv_lumi_image_t* image, uint32_t (*clock)(void));

#ifdef __cplusplus
}
#endif

#endif
