// SPDX-License-Identifier: MIT
#include "lv_lumi.h"

#include <lumi/gesture.h>
#include <lvgl_private.h>

namespace
{

constexpr uint32_t kPeriod_ms = LV_DEF_REFR_PERIOD;

struct Widget {
    lv_image_t base;
    lv_lumi_image_t* image;
    lv_timer_t* timer;  // pauses while nothing moves
    lumi::OrbitDrag drag;
    lumi::Touch touch;
    uint32_t last_ms;
};

Widget& widget_of(lv_obj_t* obj)
{
    return *reinterpret_cast<Widget*>(obj);
}

void follow(lv_timer_t* timer)
{
    lv_obj_t* const obj = static_cast<lv_obj_t*>(lv_timer_get_user_data(timer));
    Widget& widget = widget_of(obj);
    lumi_orbit next = widget.image->orbit;
    lumi::Orbit orbit = {next.azimuth_turns32, next.elevation_turns32, next.distance_q20, next.fov_turns32,
                         next.zoom_q16};
    const bool is_moving = widget.drag.next(widget.touch, lv_tick_elaps(widget.last_ms), orbit);
    widget.last_ms = lv_tick_get();
    next.azimuth_turns32 = orbit.azimuth_turns32;
    next.elevation_turns32 = orbit.elevation_turns32;
    if (!is_moving && !widget.touch.is_down) lv_timer_pause(timer);
    lv_lumi_set_orbit(obj, next);  // the last: who is told may delete the widget
}

void touch(Widget& widget)
{
    lv_point_t at;
    lv_indev_get_point(lv_indev_active(), &at);
    if (!widget.touch.is_down) widget.last_ms = lv_tick_get();
    widget.touch = {true, at.x, at.y};
    lv_timer_resume(widget.timer);
}

// A drag turns the object, not the page below. LVGL 9.6 has a function for each flag, and those for all are deprecated.
void take_drags(lv_obj_t* obj)
{
#if LVGL_VERSION_MAJOR > 9 || (LVGL_VERSION_MAJOR == 9 && LVGL_VERSION_MINOR >= 6)
    lv_obj_set_clickable(obj, true);
    lv_obj_set_scroll_chain(obj, false);
    lv_obj_set_gesture_bubble(obj, false);
#else
    lv_obj_add_flag(obj, LV_OBJ_FLAG_CLICKABLE);
    lv_obj_remove_flag(obj, LV_OBJ_FLAG_SCROLL_CHAIN);
    lv_obj_remove_flag(obj, LV_OBJ_FLAG_GESTURE_BUBBLE);
#endif
}

void construct(const lv_obj_class_t*, lv_obj_t* obj)
{
    Widget& widget = widget_of(obj);
    widget.timer = lv_timer_create(follow, kPeriod_ms, obj);
    lv_timer_pause(widget.timer);
    take_drags(obj);
}

void destruct(const lv_obj_class_t*, lv_obj_t* obj)
{
    lv_timer_delete(widget_of(obj).timer);
}

void handle(const lv_obj_class_t*, lv_event_t* event)
{
    if (lv_obj_event_base(&lv_lumi_class, event) != LV_RESULT_OK) return;
    Widget& widget = widget_of(static_cast<lv_obj_t*>(lv_event_get_current_target(event)));
    const lv_event_code_t code = lv_event_get_code(event);
    if (code == LV_EVENT_PRESSED || code == LV_EVENT_PRESSING)
        touch(widget);
    else if (code == LV_EVENT_RELEASED || code == LV_EVENT_PRESS_LOST)
        widget.touch.is_down = false;
}

constexpr lv_obj_class_t make_class()
{
    lv_obj_class_t made = {};
    made.base_class = &lv_image_class;
    made.constructor_cb = construct;
    made.destructor_cb = destruct;
    made.event_cb = handle;
    made.name = "lv_lumi";
    made.width_def = made.height_def = LV_SIZE_CONTENT;
    made.instance_size = sizeof(Widget);
    return made;
}

}  // namespace

const lv_obj_class_t lv_lumi_class = make_class();

lv_obj_t* lv_lumi_create(lv_obj_t* parent, lv_lumi_image_t* image)
{
    lv_obj_t* const obj = lv_obj_class_create_obj(&lv_lumi_class, parent);
    Widget& widget = widget_of(obj);
    widget.image = image;
    widget.drag = lumi::OrbitDrag({lumi::degrees(180) / static_cast<uint32_t>(image->screen.width_px)});
    lv_obj_class_init_obj(obj);
    lv_image_set_src(obj, image);
    return obj;
}

void lv_lumi_set_orbit(lv_obj_t* obj, lumi_orbit orbit)
{
    const lumi_orbit before = lv_lumi_get_orbit(obj);
    if (orbit.azimuth_turns32 == before.azimuth_turns32 && orbit.elevation_turns32 == before.elevation_turns32 &&
        orbit.distance_q20 == before.distance_q20 && orbit.fov_turns32 == before.fov_turns32 &&
        orbit.zoom_q16 == before.zoom_q16)
        return;
    lv_lumi_image_set_orbit(widget_of(obj).image, orbit);
    lv_obj_invalidate(obj);
    lv_obj_send_event(obj, LV_EVENT_VALUE_CHANGED, nullptr);
}

lumi_orbit lv_lumi_get_orbit(const lv_obj_t* obj)
{
    return reinterpret_cast<const Widget*>(obj)->image->orbit;
}
