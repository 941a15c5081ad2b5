// SPDX-License-Identifier: MIT
#include "lv_lumi.h"

#include <lumi/gesture.h>
#include <lvgl_private.h>

#include <algorithm>

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
    uint32_t least_zoom_q16, most_zoom_q16;  // both 0: nothing zooms
    lumi_quality quality;
    bool has_quality;
    lumi_orbit followed;  // when the frame was last controlled
};

Widget& widget_of(lv_obj_t* obj)
{
    return *reinterpret_cast<Widget*>(obj);
}

bool operator==(const lumi_orbit& a, const lumi_orbit& b)
{
    return a.azimuth_turns32 == b.azimuth_turns32 && a.elevation_turns32 == b.elevation_turns32 &&
           a.distance_q20 == b.distance_q20 && a.fov_turns32 == b.fov_turns32 && a.zoom_q16 == b.zoom_q16;
}

// Chooses how the next frame is drawn; whether one is to come. A frame that nobody sees is not waited for.
bool control(lv_obj_t* obj, const lumi_orbit& next, bool is_moving)
{
    Widget& widget = widget_of(obj);
    lv_lumi_image_t& image = *widget.image;
    if (!widget.has_quality) return false;
    if (!image.is_drawn) return lv_obj_is_visible(obj);
    const bool has_changed = is_moving || !(next == widget.followed);
    widget.followed = next;
    const lumi_frame_quality frame = lumi_quality_next(&widget.quality, image.spent, has_changed);
    if (!frame.draws) return false;
    lv_lumi_image_set_mode(&image, frame.mode);
    lv_obj_invalidate(obj);
    return true;
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
    const bool refines = control(obj, next, is_moving);
    if (!is_moving && !refines && !widget.touch.is_down) lv_timer_pause(timer);
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

// An eighth a step, as platform/simulator has it.
void zoom(lv_obj_t* obj, int32_t steps)
{
    constexpr int32_t kMostSteps = 4, kStepShare = 8;
    const Widget& widget = widget_of(obj);
    if (widget.most_zoom_q16 == 0) return;
    lumi_orbit orbit = lv_lumi_get_orbit(obj);
    const int64_t before = orbit.zoom_q16 == 0 ? LUMI_NO_ZOOM : orbit.zoom_q16;
    const int64_t after = before + before * std::clamp(steps, -kMostSteps, kMostSteps) / kStepShare;
    orbit.zoom_q16 = static_cast<uint32_t>(std::clamp<int64_t>(after, widget.least_zoom_q16, widget.most_zoom_q16));
    lv_lumi_set_orbit(obj, orbit);
}

// An encoder that edits a widget sends keys.
int32_t steps_of(lv_event_t* event)
{
    if (lv_event_get_code(event) == LV_EVENT_ROTARY) return lv_event_get_rotary_diff(event);
    if (lv_indev_get_type(lv_indev_active()) != LV_INDEV_TYPE_ENCODER) return 0;
    const uint32_t key = lv_event_get_key(event);
    return key == LV_KEY_RIGHT ? 1 : key == LV_KEY_LEFT ? -1 : 0;
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
    lv_obj_t* const obj = static_cast<lv_obj_t*>(lv_event_get_current_target(event));
    Widget& widget = widget_of(obj);
    const lv_event_code_t code = lv_event_get_code(event);
    if (code == LV_EVENT_PRESSED || code == LV_EVENT_PRESSING)
        touch(widget);
    else if (code == LV_EVENT_RELEASED || code == LV_EVENT_PRESS_LOST)
        widget.touch.is_down = false;
    else if (code == LV_EVENT_ROTARY || code == LV_EVENT_KEY)
        zoom(obj, steps_of(event));
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
    made.editable = LV_OBJ_CLASS_EDITABLE_TRUE;  // else a wheel would scroll the page
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
    if (orbit == lv_lumi_get_orbit(obj)) return;
    if (widget_of(obj).has_quality) lv_timer_resume(widget_of(obj).timer);
    lv_lumi_image_set_orbit(widget_of(obj).image, orbit);
    lv_obj_invalidate(obj);
    lv_obj_send_event(obj, LV_EVENT_VALUE_CHANGED, nullptr);
}

lumi_orbit lv_lumi_get_orbit(const lv_obj_t* obj)
{
    return reinterpret_cast<const Widget*>(obj)->image->orbit;
}

lumi_error lv_lumi_show_parts(lv_obj_t* obj)
{
    lv_lumi_image_t& image = *widget_of(obj).image;
    if (image.is_turned) {  // the frame that is to come has the parts, too
        lv_obj_invalidate(obj);
        return 0;
    }
    image.error = lumi_look_mode(image.view, image.orbit, image.mode);
    const lumi_changes changes = image.error == 0 ? lumi_changed(image.view, 1, 1) : lumi_changes{};
    for (uint32_t k = 0; k < changes.count; ++k) {
        const lumi_rect& rect = changes.rect[k];
        const int32_t left = obj->coords.x1 + rect.x_px, top = obj->coords.y1 + rect.y_px;
        const lv_area_t area = {left, top, left + rect.width_px - 1, top + rect.height_px - 1};
        lv_obj_invalidate_area(obj, &area);
    }
    return image.error;
}

void lv_lumi_set_zoom_range(lv_obj_t* obj, uint32_t least_q16, uint32_t most_q16)
{
    Widget& widget = widget_of(obj);
    widget.least_zoom_q16 = std::min(least_q16, most_q16);
    widget.most_zoom_q16 = most_q16;
}

lumi_error lv_lumi_set_quality(lv_obj_t* obj, lumi_quality_limits limits)
{
    Widget& widget = widget_of(obj);
    lumi_quality quality;
    const lumi_error error = lumi_quality_start(&quality, widget.image->view, limits);
    if (error != 0) return error;
    widget.quality = quality;
    widget.has_quality = true;
    widget.followed = lv_lumi_get_orbit(obj);
    lv_timer_resume(widget.timer);
    return 0;
}
