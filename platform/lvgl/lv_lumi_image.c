/* SPDX-License-Identifier: MIT */
#include "lv_lumi_image.h"

#include <lvgl_private.h>

#if LV_COLOR_DEPTH == 16
#define FORMAT LV_COLOR_FORMAT_RGB565A8
#else
#define FORMAT LV_COLOR_FORMAT_ARGB8888
#endif

/* The image that a source is, or null for sources of other decoders. */
static lv_lumi_image_t* image_of(const lv_image_decoder_dsc_t* session)
{
    const lv_image_dsc_t* source = session->src;
    if (session->src_type != LV_IMAGE_SRC_VARIABLE || source->header.cf != LV_COLOR_FORMAT_RAW_ALPHA ||
        source->data != (const uint8_t*)source)
        return NULL;
    return (lv_lumi_image_t*)session->src;
}

static lv_result_t get_info(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* session, lv_image_header_t* header)
{
    const lv_lumi_image_t* image = image_of(session);
    LV_UNUSED(decoder);
    if (image == NULL) return LV_RESULT_INVALID;
    *header = image->source.header;
    header->cf = FORMAT;
    return LV_RESULT_OK;
}

static lv_result_t fail(lv_lumi_image_t* image, lv_image_decoder_dsc_t* session, lumi_error error)
{
    image->error = error;
    image->is_drawn = true;
    session->error_msg = lumi_error_text(error);
    LV_LOG_WARN("%s", session->error_msg);
    return LV_RESULT_INVALID;
}

/* LVGL opens an image for each part of the screen: the view is prepared once for all of them. */
static lv_result_t open_session(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* session)
{
    lv_lumi_image_t* image = image_of(session);
    LV_UNUSED(decoder);
    image->began = image->clock();
    if (image->is_turned) image->spent = 0;
    image->error = image->is_turned ? lumi_look_mode(image->view, image->orbit, image->mode) : 0;
    if (image->error != 0) return fail(image, session, image->error);
    image->is_turned = false;
    session->user_data =
        lv_draw_buf_create((uint32_t)image->screen.width_px, (uint32_t)image->screen.rows_px, FORMAT, 0);
    return session->user_data != NULL ? LV_RESULT_OK : LV_RESULT_INVALID;
}

/* The rows of `full` that come next; false: there are none. */
static bool next_rows(const lv_area_t* full, int32_t most_rows, lv_area_t* rows)
{
    const int32_t y = rows->y1 == LV_COORD_MIN ? full->y1 : rows->y2 + 1;
    *rows = *full;
    rows->y1 = y;
    rows->y2 = LV_MIN(y + most_rows - 1, full->y2);
    return y <= full->y2;
}

/* Draws into pixels of FORMAT. RGB565A8 has coverage in a plane of its own, behind that of colour. */
static lumi_error draw_rows(lumi_view* view, const lv_area_t* rows, const lv_draw_buf_t* out)
{
    lumi_stripe stripe = {out->data, rows->x1, rows->y1, out->header.w, out->header.h, out->header.stride};
    lumi_error error = lumi_draw(view, stripe);
    if (error == 0 && FORMAT == LV_COLOR_FORMAT_RGB565A8) {
        stripe.pixels += stripe.stride_bytes * out->header.h;
        stripe.stride_bytes /= 2;
        error = lumi_draw_coverage(view, stripe);
    }
    return error;
}

static lv_result_t get_area(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* session, const lv_area_t* full,
                            lv_area_t* rows)
{
    lv_lumi_image_t* image = image_of(session);
    lv_draw_buf_t* out = session->user_data;
    lumi_error error;
    LV_UNUSED(decoder);
    if (!next_rows(full, image->screen.rows_px, rows)) return LV_RESULT_INVALID;
    out = lv_draw_buf_reshape(out, FORMAT, (uint32_t)(rows->x2 - rows->x1 + 1), (uint32_t)(rows->y2 - rows->y1 + 1), 0);
    if (out == NULL) return LV_RESULT_INVALID;
    error = draw_rows(image->view, rows, out);
    if (error != 0) return fail(image, session, error);
    session->decoded = out;
    return LV_RESULT_OK;
}

static void close_session(lv_image_decoder_t* decoder, lv_image_decoder_dsc_t* session)
{
    lv_lumi_image_t* image = image_of(session);
    LV_UNUSED(decoder);
    if (session->user_data != NULL) lv_draw_buf_destroy(session->user_data);
    if (image == NULL) return;
    image->spent += image->clock() - image->began;
    image->is_drawn = true;
}

void lv_lumi_image_decoder_init(void)
{
    lv_image_decoder_t* decoder = lv_image_decoder_create();
    lv_image_decoder_set_info_cb(decoder, get_info);
    lv_image_decoder_set_open_cb(decoder, open_session);
    lv_image_decoder_set_get_area_cb(decoder, get_area);
    lv_image_decoder_set_close_cb(decoder, close_session);
    decoder->name = "lumi";
}

lumi_error lv_lumi_image_open(lv_lumi_image_t* image, void* memory, size_t memory_bytes, const uint8_t* field,
                              size_t field_bytes, lumi_screen screen)
{
    const lv_lumi_image_t closed = {0};
    *image = closed;
    image->error = lumi_open(memory, memory_bytes, field, field_bytes, screen, &image->view);
    if (image->error != 0) return image->error;
    image->source.header.magic = LV_IMAGE_HEADER_MAGIC;
    image->source.header.cf = LV_COLOR_FORMAT_RAW_ALPHA;
    image->source.header.w = (uint16_t)screen.width_px;
    image->source.header.h = (uint16_t)screen.height_px;
    image->source.data = (const uint8_t*)image;
    image->source.data_size = sizeof *image;
    image->screen = screen;
    image->orbit.distance_q20 = LUMI_RADII(3);
    image->mode = screen.mode;
    image->clock = lv_tick_get;
    image->is_turned = true;
    return 0;
}

void lv_lumi_image_set_orbit(lv_lumi_image_t* image, lumi_orbit orbit)
{
    image->orbit = orbit;
    image->is_turned = true;
    image->is_drawn = false;
}

void lv_lumi_image_set_mode(lv_lumi_image_t* image, uint8_t mode)
{
    image->mode = mode;
    image->is_turned = true;
    image->is_drawn = false;
}

void lv_lumi_image_set_clock(lv_lumi_image_t* image, uint32_t (*clock)(void))
{
    image->clock = clock;
}
