/* SPDX-License-Identifier: MIT
 * A field on a display, from C (C99): the calls of view.h, without its types. Link lumi::c, which compiles
 * src/c/lumi.cpp; the program is linked by the C++ compiler, or with its run-time library left out, which nothing
 * needs.
 *
 *     lumi_open(memory, sizeof memory, product, product_size(), screen, &view);     once
 *     lumi_look(view, orbit);                                                       each frame
 *     lumi_draw(view, stripe);                                                      each stripe
 *
 * What is linked is said when lumi::c is compiled, by macros; one field's renderer and one format of pixels:
 *
 *     LUMI_C_PIXEL      PixelRgb565Swapped if not defined; any policy of pixel.h
 *     LUMI_C_TEXEL      a policy of texel.h: draws chord fields of that format. Not defined: surface fields
 *     LUMI_C_SEE_THROUGH  if defined, surface fields may have see-through parts
 *     LUMI_C_BACKGROUND OverBlack() if not defined; any background of background.h
 *
 * Frame and units: the sphere around the scene has radius 1; z is up. Angles are turns times 2^32, of either sign as
 * they wrap; lengths are radii times 2^20. Rules and costs of the calls are those of view.h. */
#ifndef LUMI_LUMI_H
#define LUMI_LUMI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A whole number of degrees as an angle; parts of one are quotients: LUMI_DEGREES(45) / 2. At most a million. */
#define LUMI_DEGREES(whole) ((uint32_t)(((int64_t)(whole)*4294967296 + (int64_t)6333186975989760 + 180) / 360))
/* A length in radii, up to 2047: LUMI_RADII(5) / 2 is two and a half. */
#define LUMI_RADII(whole) ((int32_t)(whole) * (int32_t)1048576)
/* In place of a field of view: the sphere fills the image, as `lumi render` has it. */
#define LUMI_FIT_SPHERE ((uint32_t)0)

#define LUMI_NO_ZOOM ((uint32_t)65536)

/* 0, or a value of lumi::ViewError (view_error.h); lumi_error_text says what to do. */
typedef uint8_t lumi_error;

/* Modes of surface fields, from the fastest to the finest. Chord fields: 2, 4, 8 or 16, see chord/render_spans.h. */
enum { LUMI_ONE_SAMPLE = 0, LUMI_ANTIALIASED = 1, LUMI_TWO_BY_TWO = 2 };

/* The image, the most rows of it in a stripe, and the mode. */
typedef struct {
    int32_t width_px, height_px; /* 1 .. 8192 */
    int32_t rows_px;             /* 1 .. height_px */
    uint8_t mode;
} lumi_screen;

/* Where the eye is: it looks at the sphere's centre, z up in the picture. */
typedef struct {
    uint32_t azimuth_turns32, elevation_turns32;
    int32_t distance_q20;
    uint32_t fov_turns32; /* over the image's longer side, or LUMI_FIT_SPHERE */
    uint32_t zoom_q16;    /* 2 * LUMI_NO_ZOOM shows everything twice as large; 0 counts as LUMI_NO_ZOOM */
} lumi_orbit;

/* A rectangle in the caller's memory, rows stride_bytes apart, top row first. */
typedef struct {
    uint8_t* pixels;
    int32_t x_px, y_px; /* where its first pixel is in the image */
    int32_t width_px, height_px;
    uint32_t stride_bytes;
} lumi_stripe;

typedef struct lumi_view lumi_view;

/* Bytes that a view takes, before the field is opened: its vertices and patches (`lumi inspect`, `lumi embed`), 0 for
 * chord fields. The macro is a constant for an array, and no less. A uint64_t array has the alignment. */
#define LUMI_MEMORY(vertices, patches, width, height, rows)                          \
    (2048 + 12 * (size_t)(vertices) + 5 * (size_t)(patches) + 4 * (size_t)(height) + \
     6 * ((size_t)(width) + 2) * ((size_t)(rows) + 2))
#define LUMI_MEMORY_TWO_BY_TWO(vertices, patches, width, height, rows) \
    (LUMI_MEMORY(vertices, patches, width, height, rows) + 18 * (size_t)(width) * (size_t)(rows))

/* The same to the byte, of a field; 0 if it cannot be opened or the screen is out of range. */
size_t lumi_memory_size(const uint8_t* field, size_t field_bytes, lumi_screen screen);

/* Checks all that decides where bytes are read, and makes a view in `memory`, at an address divisible by 8. Field and
 * memory stay as long as the view is used. After a failure *out is null. */
lumi_error lumi_open(void* memory, size_t memory_bytes, const uint8_t* field, size_t field_bytes, lumi_screen screen,
                     lumi_view** out);

/* Compares every byte of a field with the checksums that were written with it: tells damaged flash, and flash that was
 * written in part, from flash as it was written. Reads the whole field once. lumi_open does not do it. */
lumi_error lumi_verify(const uint8_t* field, size_t field_bytes);

/* The next frame's eye. A failure leaves the frame as it was. */
lumi_error lumi_look(lumi_view* view, lumi_orbit orbit);

/* A rectangle of the image; nothing where a side is 0. */
typedef struct {
    int32_t x_px, y_px, width_px, height_px;
} lumi_rect;

/* Where the object is in this frame: beside it, every pixel is background. Empty before a look. */
lumi_rect lumi_bounds(const lumi_view* view);

/* Draws every pixel of the stripe; where it lies beside the image, background. */
lumi_error lumi_draw(lumi_view* view, lumi_stripe stripe);

/* A surface field's coverage of the stripe that was drawn last, a byte a pixel: where LUMI_C_BACKGROUND is
 * OverNothing() and pixels have no room for it (RGB565A8). Views of chord fields have none: other_renderer. */
lumi_error lumi_draw_coverage(lumi_view* view, lumi_stripe coverage);

/* One short English phrase. */
const char* lumi_error_text(lumi_error error);

#ifdef __cplusplus
}
#endif

#endif
