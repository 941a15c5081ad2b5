/* SPDX-License-Identifier: MIT
 * Fields on a display, from C (C99): the calls of view.h, orbit.h, attitude.h, gesture.h, pack.h and of quality
 * control, without their types. Link lumi::c, which compiles sources of src/c; the program is linked by the C++
 * compiler, or with its run-time library left out, which nothing needs.
 *
 *     lumi_open(memory, sizeof memory, product, product_size(), screen, &view);     once
 *     lumi_look(view, orbit);                                                       each frame
 *     lumi_draw(view, stripe);                                                      each stripe
 *
 * What a program can draw is said when lumi::c is compiled, by macros:
 *
 *     LUMI_C_PIXEL        PixelRgb565Swapped if not defined; any policy of pixel.h
 *     LUMI_C_BACKGROUND   OverBlack() if not defined; what lumi_draw draws over, any background of background.h
 *     LUMI_C_TEXEL        policies of chord/texel.h, with commas between: chord fields of these formats
 *     LUMI_C_SURFACE      surface fields, also without this macro if LUMI_C_TEXEL is not defined
 *     LUMI_C_SEE_THROUGH  the same, and they may have see-through parts
 *     LUMI_C_PARTS        the same, and they may have moving parts
 *     LUMI_C_STATES       the same, and lights of theirs may be weighed
 *     LUMI_C_GLOSS        the same, and they may have gloss maps
 *
 * Where both kinds of fields are drawn, each view takes that of its field. Calls that a program does not make are not
 * linked (-ffunction-sections and --gc-sections).
 *
 * Frame and units: the sphere around the scene has radius 1; z is up. Angles are turns times 2^32, of either sign as
 * they wrap; lengths are radii times 2^20. Rules and costs of the calls are those of C++. A null pointer is an error
 * where a call returns one; no pointer may be null elsewhere, unless it is said. */
#ifndef LUMI_LUMI_H
#define LUMI_LUMI_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Makes an angle of a whole number of degrees; parts of one are quotients: LUMI_DEGREES(45) / 2. At most a million. */
#define LUMI_DEGREES(whole) ((uint32_t)(((int64_t)(whole)*4294967296 + (int64_t)6333186975989760 + 180) / 360))
/* Makes a length of radii, up to 2047: LUMI_RADII(5) / 2 is two and a half. */
#define LUMI_RADII(whole) ((int32_t)(whole) * (int32_t)1048576)
/* Stands in place of a field of view: the sphere fills the image, as `lumi render` has it. */
#define LUMI_FIT_SPHERE ((uint32_t)0)

#define LUMI_NO_ZOOM ((uint32_t)65536)

/* Is 0, or a value of lumi::ViewError (view_error.h); lumi_error_text says what to do. */
typedef uint8_t lumi_error;

/* Modes of surface fields, from the fastest to the finest. Chord fields: 2, 4, 8 or 16, see chord/render_spans.h; any
 * other is wrong_span. */
enum { LUMI_ONE_SAMPLE = 0, LUMI_ANTIALIASED = 1, LUMI_TWO_BY_TWO = 2 };

/* Names the image, the most rows of it in a stripe, and the mode of lumi_look, one of the field's layout: of surface
 * fields the finest that the view has memory for. */
typedef struct {
    int32_t width_px, height_px; /* 1 .. 8192 */
    int32_t rows_px;             /* 1 .. height_px */
    uint8_t mode;
} lumi_screen;

/* Tells where the eye is: it looks at the sphere's centre, z up in the picture. */
typedef struct {
    uint32_t azimuth_turns32, elevation_turns32;
    int32_t distance_q20;
    uint32_t fov_turns32; /* over the image's longer side, or LUMI_FIT_SPHERE */
    uint32_t zoom_q16;    /* 2 * LUMI_NO_ZOOM shows everything twice as large; 0 counts as LUMI_NO_ZOOM */
} lumi_orbit;

/* Tells where the eye is and how it is turned. right, up and forward are orthonormal, right = forward x up; forward
 * points into the scene. */
typedef struct {
    int32_t x, y, z;
} lumi_vector;
typedef struct {
    lumi_vector eye_q20, right_q30, up_q30, forward_q30;
} lumi_pose;

/* Tells how a device is held, from its sensors: a turn from its axes to those of the sphere, of any length. x is to the
 * right of the display, y up along it, z out of it towards its user. All zeros are no turn. */
typedef struct {
    int32_t w, x, y, z;
} lumi_quaternion;

/* This is a rectangle in the caller's memory, rows stride_bytes apart, top row first. */
typedef struct {
    uint8_t* pixels;
    int32_t x_px, y_px; /* where its first pixel is in the image */
    int32_t width_px, height_px;
    uint32_t stride_bytes;
} lumi_stripe;

typedef struct lumi_view lumi_view;

/* Counts the bytes that a view takes, before the field is opened: its vertices and patches (`lumi inspect`, `lumi
 * embed`), 0 for chord fields. The macro is a constant for an array, and no less. A uint64_t array has the alignment.
 */
#define LUMI_MEMORY(vertices, patches, width, height, rows)                      \
    (2048 + 12 * (size_t)(vertices) + 5 * (size_t)(patches) + (size_t)(height) + \
     (6 * ((size_t)(width) + 3) + ((size_t)(width) + 33) / 32 * 12) * ((size_t)(rows) + 2))
#define LUMI_MEMORY_TWO_BY_TWO(vertices, patches, width, height, rows) \
    (LUMI_MEMORY(vertices, patches, width, height, rows) + 18 * (size_t)(width) * (size_t)(rows))
/* To be added to either for a field with see-through patches, which are not among its patches. */
#define LUMI_SEE_THROUGH_MEMORY(see_through_patches) (2048 + 8 * (size_t)(see_through_patches))
/* To be added for a field with moving parts. */
#define LUMI_PARTS_MEMORY(parts) (160 * (size_t)(parts))
/* To be added for a field with light states. */
#define LUMI_STATES_MEMORY(see_through_patches) ((see_through_patches) != 0 ? 2344 : 800)

/* To be added for a field with gloss maps, of whose vertices so many have view tables; 0 without maps. */
#define LUMI_GLOSS_MEMORY(maps, viewed) ((maps) != 0 ? 2468 * (size_t)(maps) + 2 * (size_t)(viewed) + 8 : 0)

/* Tells them to the byte for a field; 0 if it cannot be opened or the screen is out of range. */
size_t lumi_memory_size(const uint8_t* field, size_t field_bytes, lumi_screen screen);

/* Checks all that decides where bytes are read, and makes a view in `memory`, at an address divisible by 8. Field and
 * memory stay as long as the view is used. After a failure *out is null. */
lumi_error lumi_open(void* memory, size_t memory_bytes, const uint8_t* field, size_t field_bytes, lumi_screen screen,
                     lumi_view** out);

/* Compares every byte of a field with the checksums that were written with it: tells damaged flash, and flash that was
 * written in part, from flash as it was written. Reads the whole field once. lumi_open does not do it. */
lumi_error lumi_verify(const uint8_t* field, size_t field_bytes);

/* The next frame's eye, in the screen's mode. A failure leaves the frame as it was. */
lumi_error lumi_look(lumi_view* view, lumi_orbit orbit);
/* Looks in another mode: of surface fields none finer than the screen's. */
lumi_error lumi_look_mode(lumi_view* view, lumi_orbit orbit, uint8_t mode);
/* Looks from any pose; lumi_fov_of tells a field of view. */
lumi_error lumi_look_pose(lumi_view* view, lumi_pose pose, uint32_t fov_turns32, uint8_t mode);

/* The field of view that lumi_look takes for an orbit: fitted to the sphere, and zoomed. 0 without a view. */
uint32_t lumi_fov_of(const lumi_view* view, lumi_orbit orbit);
/* Returns the pose of an orbit. */
lumi_pose lumi_pose_of(lumi_orbit orbit);
/* The eye goes round the sphere as a device is turned, as if its display were a window. */
lumi_pose lumi_held_pose(lumi_quaternion turn, int32_t distance_q20);
/* Returns a pose beside another, to its right: stereo. */
lumi_pose lumi_moved_right(lumi_pose pose, int32_t offset_q20);
/* Turns the picture clockwise, for a display that is mounted askew: a quarter turn puts what was up to the right. */
lumi_pose lumi_rolled(lumi_pose pose, uint32_t roll_turns32);

/* A rectangle of the image; nothing where a side is 0. */
typedef struct {
    int32_t x_px, y_px, width_px, height_px;
} lumi_rect;

/* Where the object is in this frame: beside it, every pixel is background. Empty before a look. */
lumi_rect lumi_bounds(const lumi_view* view);

/* Turns or slides a moving part of a surface field from the next look on, right-handed about its axis, or along it in
 * radii times 2^20. `lumi embed` names the parts. Values beyond the part's range are its nearer end. bad_argument: no
 * such part, or one that moves in the other way. */
lumi_error lumi_turn(lumi_view* view, uint32_t part, uint32_t turns32);
lumi_error lumi_slide(lumi_view* view, uint32_t part, int32_t offset_q20);

/* Weighs a light state of a surface field from the next look on: how much of its light shows in each channel, 0 to
 * LUMI_FULL_WEIGHT; more counts as that. `lumi embed` names the states. bad_argument: no such state. */
#define LUMI_FULL_WEIGHT 4096
lumi_error lumi_set_state(lumi_view* view, uint32_t state, uint16_t r_q12, uint16_t g_q12, uint16_t b_q12);

/* Tells the rectangles beside which the last look changed no pixel. Their sides are multiples of `align` as far as the
 * image reaches. At the first look, without LUMI_C_PARTS, and of chord fields it is the image. Nothing without a view
 * or a look. */
typedef struct {
    lumi_rect rect[4];
    uint32_t count;
} lumi_changes;
lumi_changes lumi_changed(const lumi_view* view, uint32_t align_x, uint32_t align_y);

/* Draws every pixel of the stripe over LUMI_C_BACKGROUND; where it lies beside the image, background. */
lumi_error lumi_draw(lumi_view* view, lumi_stripe stripe);

/* Draws over another background, whatever LUMI_C_BACKGROUND is; each that is called links a renderer of its own.
 * Over the stripe: over what it holds. Over nothing: coverage goes into pixels that have room for it. Chord fields are
 * not drawn over nothing: other_renderer. */
typedef struct {
    uint8_t r, g, b;
} lumi_colour;
lumi_error lumi_draw_over_colour(lumi_view* view, lumi_stripe stripe, lumi_colour colour);
lumi_error lumi_draw_over_stripe(lumi_view* view, lumi_stripe stripe);
lumi_error lumi_draw_over_nothing(lumi_view* view, lumi_stripe stripe);

/* A surface field's coverage of the stripe that was drawn last, over nothing, a byte a pixel: where pixels have no room
 * for it (RGB565A8). Views of chord fields have none: other_renderer. */
lumi_error lumi_draw_coverage(lumi_view* view, lumi_stripe coverage);

/* Turns an orbit by a finger, see gesture.h. */
typedef struct {
    uint32_t turns32_per_px;  /* LUMI_DEGREES(180) / 240: half a turn across the display */
    uint32_t half_life_ms;    /* how long an object that runs on takes to halve its speed: 250; 0: it stops at once */
    uint32_t elevation_limit; /* the elevation stays between -limit and limit: LUMI_DEGREES(85) */
} lumi_drag_settings;
typedef struct {
    bool is_down;
    int32_t x_px, y_px; /* to the right and down; where it was last, if it is up */
} lumi_touch;
typedef struct {
    uint64_t state[5];
} lumi_drag;

void lumi_drag_start(lumi_drag* drag, lumi_drag_settings settings);
/* Each frame: changes the orbit's angles; whether it moves. `elapsed_ms` since the last call. */
bool lumi_drag_next(lumi_drag* drag, lumi_touch touch, uint32_t elapsed_ms, lumi_orbit* orbit);

/* Holds a frame rate: coarser modes while the object moves too fast for finer ones, the finest at rest. */
typedef struct {
    uint32_t budget;                                 /* what a frame may take, in any unit, below 2^29 */
    uint8_t coarsest, finest_moving, finest_resting; /* modes of the view's field */
} lumi_quality_limits;
typedef struct {
    uint64_t state[7];
} lumi_quality;
typedef struct {
    bool draws; /* false: the finest picture is on the display already */
    uint8_t mode;
} lumi_frame_quality;

/* bad_argument for limits that are no modes of the view's field or in the wrong order, mode_too_fine for those that
 * lumi_look_mode refuses. */
lumi_error lumi_quality_start(lumi_quality* quality, const lumi_view* view, lumi_quality_limits limits);
/* Each frame: how to draw it. `last_frame` is what drawing the last answer took. */
lumi_frame_quality lumi_quality_next(lumi_quality* quality, uint32_t last_frame, bool moving);

/* Stripes of PixelGrey8, packed for displays of 16 greys or two by ordered dither: see pack.h. `out` may be the
 * stripe's own memory, if its rows are no farther apart. */
#define LUMI_GREY4_BYTES(width) (((uint32_t)(width) + 1) / 2)
#define LUMI_MONO1_BYTES(width) (((uint32_t)(width) + 7) / 8)
void lumi_pack_grey4(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes);
void lumi_pack_mono1(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes);
/* Packs pages of an OLED: eight rows a byte. */
void lumi_pack_pages(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes);
/* Dithers stripes of PixelRgb888 to the two bytes a pixel of PixelRgb565, and of PixelRgb565Swapped. */
void lumi_dither_rgb565(lumi_stripe rgb, uint8_t* out, uint32_t out_stride_bytes);
void lumi_dither_rgb565_swapped(lumi_stripe rgb, uint8_t* out, uint32_t out_stride_bytes);

/* Returns one short English phrase. */
const char* lumi_error_text(lumi_error error);

#ifdef __cplusplus
}
#endif

#endif
