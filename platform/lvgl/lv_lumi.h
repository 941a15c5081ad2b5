/* SPDX-License-Identifier: MIT
 * A widget of LVGL 9.3 and later: an lv_image of a field that a finger or a mouse turns and a wheel zooms. It runs on
 * when it is let go, and sends LV_EVENT_VALUE_CHANGED when its orbit has changed. */
#ifndef LV_LUMI_H
#define LV_LUMI_H

#include "lv_lumi_image.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const lv_obj_class_t lv_lumi_class;

/* Shows an image that was opened, which stays as long as the widget. Half a turn a width of the image. */
lv_obj_t* lv_lumi_create(lv_obj_t* parent, lv_lumi_image_t* image);

void lv_lumi_set_orbit(lv_obj_t* lumi, lumi_orbit orbit);
lumi_orbit lv_lumi_get_orbit(const lv_obj_t* lumi);

/* Shows moving parts as lumi_turn and lumi_slide have set them in the image's view, and lights as lumi_set_state has:
 * prepares the frame, and lets LVGL redraw what has changed. The widget shows the image at its own size. */
lumi_error lv_lumi_show_parts(lv_obj_t* lumi);

/* A mouse's wheel, and an encoder that edits the widget, zoom between these by an eighth a step; LUMI_NO_ZOOM shows the
 * whole sphere. At first nothing zooms. */
void lv_lumi_set_zoom_range(lv_obj_t* lumi, uint32_t least_q16, uint32_t most_q16);

/* Holds a frame rate: coarser modes while the orbit changes too fast for finer ones, the finest at rest. The budget is
 * what drawing a frame may take in the unit of the image's clock (milliseconds, or lv_lumi_image_set_clock). Errors are
 * those of lumi_quality_start, and leave the widget as it was. */
lumi_error lv_lumi_set_quality(lv_obj_t* lumi, lumi_quality_limits limits);

#ifdef __cplusplus
}
#endif

#endif
