// SPDX-License-Identifier: MIT
// lumi.h for the one renderer that the build names; compiled with the program that uses it.
#include "lumi/lumi.h"

#ifdef LUMI_C_TEXEL
#include "lumi/chord/view.h"
#else
#include "lumi/surface/view.h"
#endif

#ifndef LUMI_C_PIXEL
#define LUMI_C_PIXEL PixelRgb565Swapped
#endif
#ifndef LUMI_C_BACKGROUND
#define LUMI_C_BACKGROUND OverBlack()
#endif

using namespace lumi;

#ifdef LUMI_C_TEXEL
using AnyField = Field;
#elif defined(LUMI_C_SEE_THROUGH)
using AnyField = SeeThroughField;
using AnyFrame = SeeThroughFrame;
using AnyMemory = SeeThroughMemory;
#else
using AnyField = SurfaceField;
using AnyFrame = SurfaceFrame;
using AnyMemory = SurfaceMemory;
#endif

struct lumi_view {
    lumi_screen screen;
    bool has_look;
    AnyField field;
#ifdef LUMI_C_TEXEL
    Camera camera;
#else
    AnyFrame frame;
    AnyMemory memory;
    uint32_t samples_bytes;
    uint32_t* samples;
#endif

    static void* operator new(size_t, void* memory)
    {
        return memory;
    }  // <new> is not everywhere
};

namespace
{

using Pixel = LUMI_C_PIXEL;

constexpr lumi_error code(ViewError error)
{
    return static_cast<lumi_error>(error);
}

bool is_in_range(const lumi_screen& s)
{
    return s.width_px >= 1 && s.width_px <= kMaxImageSide && s.height_px >= 1 && s.height_px <= kMaxImageSide &&
           s.rows_px >= 1 && s.rows_px <= s.height_px;
}

#ifdef LUMI_C_TEXEL

ViewError open_any(const uint8_t* bytes, size_t size, const lumi_screen&, Field& field)
{
    return detail::open_for_spans(bytes, size, LUMI_C_TEXEL::kFormat, field);
}

size_t size_of(const Field&, const lumi_screen&)
{
    return sizeof(lumi_view);
}

void set_memory(lumi_view&) {}

ViewError look_at(lumi_view& view, const Pose& pose, const Image& image)
{
    return detail::view_error(make_camera(pose, image, view.camera));
}

PixelRect bounds_of(const lumi_view& view)
{
    return detail::covered_rectangle(view.camera);
}

ViewError draw_part(const lumi_view& view, const Stripe& stripe, const detail::StripePart&)
{
    const RenderError error =
        render_spans<Linear, LUMI_C_TEXEL, Pixel>(view.field, view.camera, LUMI_C_BACKGROUND, stripe, view.screen.mode);
    return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
}

ViewError draw_coverage_of_part(const lumi_view&, const Stripe&, const detail::StripePart&)
{
    return ViewError::other_renderer;
}

#else

// What lies behind the view in the caller's memory, in this order.
struct Places {
    size_t vertices, samples, order, links, bands, end;
};

uint32_t samples_bytes(const lumi_screen& s)
{
    return (surface_stripe_bytes<Pixel>(s.width_px, s.rows_px, static_cast<SurfaceMode>(s.mode)) + 3) / 4 * 4;
}

#ifdef LUMI_C_SEE_THROUGH
uint32_t order_of(const SeeThroughField& field)
{
    return see_through_order(field.see_through_count);
}

SeeThroughMemory memory_of(const SurfaceMemory& opaque, void* order)
{
    return {opaque, static_cast<uint32_t*>(order)};
}
#else
uint32_t order_of(const SurfaceField&)
{
    return 0;
}

SurfaceMemory memory_of(const SurfaceMemory& memory, void*)
{
    return memory;
}
#endif

Places places_of(const AnyField& field, const lumi_screen& s)
{
    Places p{};
    p.vertices = sizeof(lumi_view);
    p.samples = p.vertices + field.vertex_count * sizeof(SurfaceVertex);
    p.order = p.samples + samples_bytes(s);
    p.links = p.order + order_of(field) * sizeof(uint32_t);
    p.bands = p.links + surface_links(field.patch_count) * sizeof(uint16_t);
    p.end = p.bands + surface_bands(s.height_px, surface_band_log2(s.rows_px)) * sizeof(uint16_t);
    return p;
}

ViewError open_any(const uint8_t* bytes, size_t size, const lumi_screen& screen, AnyField& field)
{
    if (screen.mode > LUMI_TWO_BY_TWO) return ViewError::bad_argument;
    return detail::view_error(open_surface(bytes, size, field));
}

size_t size_of(const AnyField& field, const lumi_screen& screen)
{
    return places_of(field, screen).end;
}

void set_memory(lumi_view& view)
{
    uint8_t* const base = reinterpret_cast<uint8_t*>(&view);
    const Places p = places_of(view.field, view.screen);
    const auto at = [&](size_t place) { return static_cast<void*>(base + place); };
    const SurfaceMemory memory = {static_cast<SurfaceVertex*>(at(p.vertices)), static_cast<uint16_t*>(at(p.links)),
                                  static_cast<uint16_t*>(at(p.bands)), surface_band_log2(view.screen.rows_px)};
    view.memory = memory_of(memory, at(p.order));
    view.samples = static_cast<uint32_t*>(at(p.samples));
    view.samples_bytes = samples_bytes(view.screen);
}

ViewError look_at(lumi_view& view, const Pose& pose, const Image& image)
{
    return detail::look_at_surface<Pixel, SurfaceMode::two_by_two>(
        view.field, pose, image, static_cast<SurfaceMode>(view.screen.mode), view.memory, view.frame);
}

PixelRect bounds_of(const lumi_view& view)
{
    return detail::bounds_of(view.frame);
}

ViewError draw_part(const lumi_view& view, const Stripe& stripe, const detail::StripePart& part)
{
    const ViewError error = detail::check_samples<Pixel>(view.frame, part, view.samples_bytes);
    if (error == ViewError::none) render_surface<Pixel>(view.frame, LUMI_C_BACKGROUND, stripe, view.samples);
    return error;
}

ViewError draw_coverage_of_part(const lumi_view& view, const Stripe& coverage, const detail::StripePart& part)
{
    const ViewError error = detail::check_samples<Pixel>(view.frame, part, view.samples_bytes);
    if (error == ViewError::none) render_coverage(view.frame, coverage, view.samples);
    return error;
}

#endif

ViewError open_checked(const uint8_t* bytes, size_t size, const lumi_screen& screen, AnyField& field)
{
    if (bytes == nullptr || !is_in_range(screen)) return ViewError::bad_argument;
    return open_any(bytes, size, screen, field);
}

ViewError check_memory(const void* memory, size_t bytes)
{
    if (memory == nullptr) return ViewError::bad_argument;
    if (reinterpret_cast<uintptr_t>(memory) % 8 != 0) return ViewError::unaligned_memory;
    return bytes < sizeof(lumi_view) ? ViewError::memory_too_small : ViewError::none;
}

// A call of `draw` with a stripe that was checked.
template <class Draw>
lumi_error drawn(lumi_view* view, const lumi_stripe& s, uint32_t pixel_bytes, Draw draw)
{
    if (view == nullptr) return code(ViewError::no_field);
    if (!view->has_look) return code(ViewError::no_look);
    const Stripe stripe = {s.pixels, s.x_px, s.y_px, s.width_px, s.height_px, s.stride_bytes};
    detail::StripePart part = {};
    const ViewError error =
        detail::check_stripe(stripe, {view->screen.width_px, view->screen.height_px}, pixel_bytes, part);
    return code(error == ViewError::none ? draw(*view, stripe, part) : error);
}

}  // namespace

size_t lumi_memory_size(const uint8_t* field, size_t field_bytes, lumi_screen screen)
{
    AnyField opened;
    return open_checked(field, field_bytes, screen, opened) == ViewError::none ? size_of(opened, screen) : 0;
}

lumi_error lumi_open(void* memory, size_t memory_bytes, const uint8_t* field, size_t field_bytes, lumi_screen screen,
                     lumi_view** out)
{
    if (out == nullptr) return code(ViewError::bad_argument);
    *out = nullptr;
    if (const ViewError error = check_memory(memory, memory_bytes); error != ViewError::none) return code(error);
    lumi_view& view = *new (memory) lumi_view;
    view.screen = screen;
    view.has_look = false;
    if (const ViewError error = open_checked(field, field_bytes, screen, view.field); error != ViewError::none)
        return code(error);
    if (memory_bytes < size_of(view.field, screen)) return code(ViewError::memory_too_small);
    set_memory(view);
    *out = &view;
    return code(ViewError::none);
}

lumi_error lumi_verify(const uint8_t* field, size_t field_bytes)
{
    return code(field == nullptr ? ViewError::bad_argument : detail::view_error(verify_field(field, field_bytes)));
}

lumi_error lumi_look(lumi_view* view, lumi_orbit o)
{
    if (view == nullptr) return code(ViewError::no_field);
    const Orbit orbit = {o.azimuth_turns32, o.elevation_turns32, o.distance_q20, o.fov_turns32, o.zoom_q16};
    const ViewError error =
        look_at(*view, pose_of(orbit), image_of(orbit, view->screen.width_px, view->screen.height_px));
    if (error == ViewError::none) view->has_look = true;
    return code(error);
}

lumi_rect lumi_bounds(const lumi_view* view)
{
    if (view == nullptr || !view->has_look) return {0, 0, 0, 0};
    const PixelRect r = bounds_of(*view);
    return {r.x_px, r.y_px, r.width_px, r.height_px};
}

lumi_error lumi_draw(lumi_view* view, lumi_stripe s)
{
    return drawn(view, s, Pixel::kBytes, draw_part);
}

lumi_error lumi_draw_coverage(lumi_view* view, lumi_stripe s)
{
    return drawn(view, s, 1, draw_coverage_of_part);
}

const char* lumi_error_text(lumi_error error)
{
    return error_text(static_cast<ViewError>(error));
}
