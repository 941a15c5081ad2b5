/* SPDX-License-Identifier: MIT
 * A widget of LVGL 9.3 and later: an lv_image of a field that a finger or a mouse turns. It runs on when it is let go,
 * and sends LV_EVENT_VALUE_CHANGED when its orbit has changed. */
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

#ifdef __cplusplus
}
#endif

#endif
