/* SPDX-License-Identifier: MIT
 * lumi_lvgl FOLDER
 * A desk clock that a finger turns and a wheel zooms, under labels and a slider; it is drawn coarser while it moves.
 * Writes the screen before and after a drag, and zoomed, to FOLDER/frame-0.raw to frame-2.raw, and what
 * tools/lab/devices.sh compares them by: where the object is, its orbit, and where widgets lie over it. Fails where it
 * moves or rests in a wrong mode. */
#include <stdio.h>

#include "desk_clock.h" /* written by lumi_add_field */
#include "headless.h"
#include "lv_lumi.h"

enum { SIDE = 232, ROWS = 16, MARGIN = 10 /* pixels around the slider that its knob may cover */ };

static uint64_t memory[(LUMI_MEMORY(desk_clock_vertices, desk_clock_patches, SIDE, SIDE, ROWS) +
                        LUMI_GLOSS_MEMORY(desk_clock_gloss, desk_clock_viewed)) /
                           8 +
                       1];
static lv_lumi_image_t image;
static lv_obj_t *clock_widget, *title, *angle, *slider;
static uint8_t coarsest_seen = LUMI_TWO_BY_TWO;

/* Parts of a frame take so long by this clock that antialiased frames, of eight parts, are too slow. */
enum { ONE_SAMPLE_TAKES = 5, ANTIALIASED_TAKES = 10, BUDGET = 60 };
static uint32_t made_up_clock(void)
{
    static uint32_t now;
    return now += image.mode == LUMI_ONE_SAMPLE ? ONE_SAMPLE_TAKES : ANTIALIASED_TAKES;
}

static int32_t in_degrees(uint32_t turns32)
{
    return (int32_t)(((int64_t)(int32_t)turns32 * 360 + ((int64_t)1 << 31)) >> 32);
}

static void show_angle(lv_event_t* event)
{
    const lumi_orbit orbit = lv_lumi_get_orbit(clock_widget);
    LV_UNUSED(event);
    if (image.mode < coarsest_seen) coarsest_seen = image.mode;
    lv_label_set_text_fmt(angle, "%d°", (int)in_degrees(orbit.azimuth_turns32));
    lv_slider_set_value(slider, in_degrees(orbit.elevation_turns32), LV_ANIM_OFF);
}

static void tilt(lv_event_t* event)
{
    lumi_orbit orbit = lv_lumi_get_orbit(clock_widget);
    LV_UNUSED(event);
    orbit.elevation_turns32 = LUMI_DEGREES(lv_slider_get_value(slider));
    lv_lumi_set_orbit(clock_widget, orbit);
}

static lv_obj_t* label(const lv_font_t* font, lv_align_t align, int32_t x, int32_t y)
{
    lv_obj_t* const made = lv_label_create(lv_screen_active());
    lv_obj_set_style_text_font(made, font, 0);
    lv_obj_set_style_text_color(made, lv_color_white(), 0);
    lv_obj_align(made, align, x, y);
    return made;
}

static void make_screen(void)
{
    lv_obj_set_style_bg_color(lv_screen_active(), lv_color_black(), 0);
    clock_widget = lv_lumi_create(lv_screen_active(), &image);
    lv_obj_align(clock_widget, LV_ALIGN_CENTER, 0, -2);
    lv_obj_add_event_cb(clock_widget, show_angle, LV_EVENT_VALUE_CHANGED, NULL);
    title = label(&lv_font_montserrat_20, LV_ALIGN_TOP_LEFT, 12, 10);
    lv_label_set_text(title, "Desk clock");
    angle = label(&lv_font_montserrat_14, LV_ALIGN_TOP_RIGHT, -12, 14);
    slider = lv_slider_create(lv_screen_active());
    lv_slider_set_range(slider, -85, 85);
    lv_obj_set_size(slider, 200, 8);
    lv_obj_align(slider, LV_ALIGN_BOTTOM_MID, 0, -20);
    lv_obj_add_event_cb(slider, tilt, LV_EVENT_VALUE_CHANGED, NULL);
}

static void report_over(lv_obj_t* widget)
{
    lv_area_t area;
    lv_obj_get_coords(widget, &area);
    printf("over %d %d %d %d\n", (int)area.x1 - MARGIN, (int)area.y1 - MARGIN, (int)area.x2 + MARGIN,
           (int)area.y2 + MARGIN);
}

static int report(const char* folder, int frame)
{
    const lumi_orbit orbit = lv_lumi_get_orbit(clock_widget);
    char path[512];
    printf("frame %d at %d %d side %d rows %d azimuth %lu elevation %lu zoom %lu flushes %lu\n", frame,
           (int)lv_obj_get_x(clock_widget), (int)lv_obj_get_y(clock_widget), SIDE, ROWS,
           (unsigned long)orbit.azimuth_turns32, (unsigned long)orbit.elevation_turns32, (unsigned long)orbit.zoom_q16,
           (unsigned long)headless_flushes());
    report_over(title);
    report_over(angle);
    report_over(slider);
    snprintf(path, sizeof path, "%s/frame-%d.raw", folder, frame);
    return headless_write(path);
}

static int control_clock(void)
{
    const lumi_quality_limits limits = {BUDGET, LUMI_ONE_SAMPLE, LUMI_ANTIALIASED, LUMI_ANTIALIASED};
    const lumi_quality_limits too_fine = {BUDGET, LUMI_ONE_SAMPLE, LUMI_TWO_BY_TWO, LUMI_TWO_BY_TWO};
    lv_lumi_image_set_clock(&image, made_up_clock);
    lv_lumi_set_zoom_range(clock_widget, LUMI_NO_ZOOM, 4 * LUMI_NO_ZOOM);
    return lv_lumi_set_quality(clock_widget, too_fine) != 0 && lv_lumi_set_quality(clock_widget, limits) == 0;
}

/* The finest picture is shown at rest, and then nothing is drawn any more. */
static int rests_finest(void)
{
    const uint32_t flushes = headless_flushes();
    headless_run(500);
    return image.mode == LUMI_ANTIALIASED && image.error == 0 && headless_flushes() == flushes;
}

int main(int count, char** arguments)
{
    const lumi_screen screen = {SIDE, SIDE, ROWS, LUMI_ANTIALIASED};
    const lumi_orbit orbit = {LUMI_DEGREES(30), LUMI_DEGREES(20), LUMI_RADII(3), LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
    if (count != 2) return 2;
    headless_start();
    lv_lumi_image_decoder_init();
    if (lv_lumi_image_open(&image, memory, sizeof memory, desk_clock, desk_clock_size(), screen) != 0) return 1;
    make_screen();
    lv_lumi_set_orbit(clock_widget, orbit);
    headless_run(100);
    if (report(arguments[1], 0) != 0 || !control_clock()) return 1;
    headless_run(500);
    headless_drag((lv_point_t){180, 120}, (lv_point_t){140, 105});
    headless_run(2000);
    printf("moved in mode %u, rests in mode %u\n", coarsest_seen, image.mode);
    if (report(arguments[1], 1) != 0 || coarsest_seen != LUMI_ONE_SAMPLE || !rests_finest()) return 1;
    headless_wheel(3);
    headless_run(1000);
    return report(arguments[1], 2) != 0 || !rests_finest();
}
