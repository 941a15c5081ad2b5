/* SPDX-License-Identifier: MIT */
#include "calls.h"

lumi_error look_in_c(lumi_view* view, const frame_in_c* frame)
{
    const uint32_t fov_turns32 = lumi_fov_of(view, frame->orbit);
    lumi_pose pose = lumi_pose_of(frame->orbit);
    if (frame->eye == EYE_OF_SCREEN) return lumi_look(view, frame->orbit);
    if (frame->eye == EYE_OF_MODE) return lumi_look_mode(view, frame->orbit, frame->mode);
    if (frame->eye == EYE_HELD) pose = lumi_held_pose(frame->turn, frame->orbit.distance_q20);
    if (frame->eye == EYE_TO_THE_RIGHT) pose = lumi_moved_right(pose, frame->offset_q20);
    if (frame->eye == EYE_ROLLED) pose = lumi_rolled(pose, frame->orbit.azimuth_turns32 * 3);
    return lumi_look_pose(view, pose, fov_turns32, frame->mode);
}

static lumi_error draw(lumi_view* view, const frame_in_c* frame, lumi_stripe stripe)
{
    switch (frame->background) {
        case OVER_COLOUR:
            return lumi_draw_over_colour(view, stripe, frame->colour);
        case OVER_STRIPE:
            return lumi_draw_over_stripe(view, stripe);
        case OVER_NOTHING:
            return lumi_draw_over_nothing(view, stripe);
        default:
            return lumi_draw(view, stripe);
    }
}

lumi_error draw_stripe_in_c(lumi_view* view, const frame_in_c* frame, int32_t y, uint8_t* image, uint8_t* coverage)
{
    const int32_t width = frame->screen.width_px, left = frame->screen.height_px - y;
    const uint32_t stride = (uint32_t)width * frame->pixel_bytes;
    lumi_stripe stripe = {0};
    lumi_error error;
    stripe.pixels = image + (uint32_t)y * stride;
    stripe.y_px = y;
    stripe.width_px = width;
    stripe.height_px = left < frame->screen.rows_px ? left : frame->screen.rows_px;
    stripe.stride_bytes = stride;
    error = draw(view, frame, stripe);
    if (error != 0 || coverage == NULL) return error;
    stripe.pixels = coverage + y * width;
    stripe.stride_bytes = (uint32_t)width;
    return lumi_draw_coverage(view, stripe);
}

lumi_error start_control_in_c(control_in_c* control, const lumi_view* view, lumi_drag_settings settings,
                              lumi_quality_limits limits)
{
    const lumi_orbit orbit = {LUMI_DEGREES(30), LUMI_DEGREES(20), LUMI_RADII(3), LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
    control->orbit = orbit;
    lumi_drag_start(&control->drag, settings);
    return lumi_quality_start(&control->quality, view, limits);
}

lumi_frame_quality next_control_in_c(control_in_c* control, lumi_touch touch, uint32_t elapsed_ms, uint32_t last_frame)
{
    const bool is_moving = lumi_drag_next(&control->drag, touch, elapsed_ms, &control->orbit);
    return lumi_quality_next(&control->quality, last_frame, is_moving);
}

void pack_in_c(lumi_stripe grey, uint8_t* grey4, uint8_t* mono1, uint8_t* pages)
{
    lumi_pack_grey4(grey, grey4, LUMI_GREY4_BYTES(grey.width_px) + 4);
    lumi_pack_mono1(grey, mono1, LUMI_MONO1_BYTES(grey.width_px) + 4);
    lumi_pack_pages(grey, pages, (uint32_t)grey.width_px + 4);
}

void dither_in_c(lumi_stripe rgb, uint8_t* low_first, uint8_t* high_first)
{
    lumi_dither_rgb565(rgb, low_first, 2 * (uint32_t)rgb.width_px);
    lumi_dither_rgb565_swapped(rgb, high_first, 2 * (uint32_t)rgb.width_px);
}
