// SPDX-License-Identifier: MIT
// lumi.h's renderer for the pixels that LVGL takes, see lv_lumi_image.h.
#include <lvgl.h>

#if LV_COLOR_DEPTH == 16
#define LUMI_C_PIXEL PixelRgb565
#else
#define LUMI_C_PIXEL PixelArgb8888
#endif
#define LUMI_C_BACKGROUND OverNothing()

#include "../../core/src/c/lumi.cpp"
#include "../../core/src/c/parts.cpp"
#include "../../core/src/c/quality.cpp"
#include "../../core/src/c/states.cpp"
