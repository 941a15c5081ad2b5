/* SPDX-License-Identifier: MIT
 * What a firmware in C99 does by the calls of lumi.h, all of them, for Pair of views.h and control_test.cpp. */
#ifndef LUMI_TESTS_CALLS_H
#define LUMI_TESTS_CALLS_H

#include <lumi/lumi.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum { EYE_OF_SCREEN, EYE_OF_MODE, EYE_OF_POSE, EYE_HELD, EYE_TO_THE_RIGHT, EYE_ROLLED, EYES } frame_eye;
typedef enum { OVER_DEFAULT, OVER_COLOUR, OVER_STRIPE, OVER_NOTHING, BACKGROUNDS } frame_background;

typedef struct {
    lumi_screen screen;
    uint32_t pixel_bytes;
    uint8_t mode;
    frame_eye eye;
    lumi_orbit orbit;
    lumi_quaternion turn;
    int32_t offset_q20;
    frame_background background;
    lumi_colour colour;
} frame_in_c;

lumi_error look_in_c(lumi_view* view, const frame_in_c* frame);
/* A stripe of whole scanlines from y on, of an image that begins at `image`; its coverage, too, if that is not null. */
lumi_error draw_stripe_in_c(lumi_view* view, const frame_in_c* frame, int32_t y, uint8_t* image, uint8_t* coverage);

typedef struct {
    lumi_drag drag;
    lumi_quality quality;
    lumi_orbit orbit;
} control_in_c;

lumi_error start_control_in_c(control_in_c* control, const lumi_view* view, lumi_drag_settings settings,
                              lumi_quality_limits limits);
lumi_frame_quality next_control_in_c(control_in_c* control, lumi_touch touch, uint32_t elapsed_ms, uint32_t last_frame);

/* Packed by 4 bits a pixel, by 1, and in pages, whose rows are 4 bytes longer than they need to be. */
void pack_in_c(lumi_stripe grey, uint8_t* grey4, uint8_t* mono1, uint8_t* pages);
void dither_in_c(lumi_stripe rgb, uint8_t* low_first, uint8_t* high_first);

#ifdef __cplusplus
}
#endif

#endif
