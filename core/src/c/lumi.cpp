// SPDX-License-Identifier: MIT
// lumi.h for what the build's macros name; compiled with the program that uses it.
#include "view.h"

using namespace lumi;
using namespace lumi::detail;
using namespace lumi::detail::c;

namespace
{

bool is_in_range(const lumi_screen& s)
{
    return s.width_px >= 1 && s.width_px <= kMaxImageSide && s.height_px >= 1 && s.height_px <= kMaxImageSide &&
           s.rows_px >= 1 && s.rows_px <= s.height_px;
}

ViewError open_checked(const uint8_t* bytes, size_t size, const lumi_screen& screen, Drawing::Field& field)
{
    if (bytes == nullptr || !is_in_range(screen)) return ViewError::bad_argument;
    return Drawing::open(bytes, size, screen, field);
}

size_t bytes_of(const Drawing::Field& field, const lumi_screen& screen)
{
    return sizeof(lumi_view) + Drawing::bytes_of(field, screen);
}

ViewError check_memory(const void* memory, size_t bytes)
{
    if (memory == nullptr) return ViewError::bad_argument;
    if (reinterpret_cast<uintptr_t>(memory) % 8 != 0) return ViewError::unaligned_memory;
    return bytes < sizeof(lumi_view) ? ViewError::memory_too_small : ViewError::none;
}

}  // namespace

size_t lumi_memory_size(const uint8_t* field, size_t field_bytes, lumi_screen screen)
{
    Drawing::Field opened;
    return open_checked(field, field_bytes, screen, opened) == ViewError::none ? bytes_of(opened, screen) : 0;
}

lumi_error lumi_open(void* memory, size_t memory_bytes, const uint8_t* field, size_t field_bytes, lumi_screen screen,
                     lumi_view** out)
{
    if (out == nullptr) return code(ViewError::bad_argument);
    *out = nullptr;
    if (const ViewError error = check_memory(memory, memory_bytes); error != ViewError::none) return code(error);
    Drawing::Field opened;
    if (const ViewError error = open_checked(field, field_bytes, screen, opened); error != ViewError::none)
        return code(error);
    if (memory_bytes < bytes_of(opened, screen)) return code(ViewError::memory_too_small);
    lumi_view& view = *new (memory) lumi_view;
    view.begin(field, field_bytes, opened, screen);
    *out = &view;
    return code(ViewError::none);
}

lumi_error lumi_verify(const uint8_t* field, size_t field_bytes)
{
    return code(field == nullptr ? ViewError::bad_argument : view_error(verify_field(field, field_bytes)));
}

lumi_error lumi_look(lumi_view* view, lumi_orbit orbit)
{
    return lumi_look_mode(view, orbit, view == nullptr ? uint8_t{0} : view->screen().mode);
}

lumi_error lumi_look_mode(lumi_view* view, lumi_orbit orbit, uint8_t mode)
{
    return code(view == nullptr ? ViewError::no_field : view->look(in_cpp(orbit), mode));
}

lumi_error lumi_look_pose(lumi_view* view, lumi_pose pose, uint32_t fov_turns32, uint8_t mode)
{
    return code(view == nullptr ? ViewError::no_field : view->look(in_cpp(pose), fov_turns32, mode));
}

uint32_t lumi_fov_of(const lumi_view* view, lumi_orbit orbit)
{
    return view == nullptr ? 0 : view->fov_of(in_cpp(orbit));
}

lumi_rect lumi_bounds(const lumi_view* view)
{
    if (view == nullptr) return {0, 0, 0, 0};
    const PixelRect r = view->bounds();
    return {r.x_px, r.y_px, r.width_px, r.height_px};
}

lumi_error lumi_draw(lumi_view* view, lumi_stripe stripe)
{
    return drawn_over(LUMI_C_BACKGROUND, view, stripe);
}

lumi_error lumi_draw_coverage(lumi_view* view, lumi_stripe coverage)
{
    return code(view == nullptr ? ViewError::no_field : view->draw_coverage(in_cpp(coverage)));
}

const char* lumi_error_text(lumi_error error)
{
    return error_text(static_cast<ViewError>(error));
}
