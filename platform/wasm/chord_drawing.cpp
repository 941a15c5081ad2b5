// SPDX-License-Identifier: MIT
// A mode is a reconstruction: the paper's is drawn pixel by pixel, the others by spans. Fields that spans do not draw
// have one mode, pixel by pixel.
#include "drawing.h"
#include "lumi/chord/camera.h"
#include "lumi/chord/field.h"
#include "lumi/chord/render_spans.h"
#include "lumi/chord/texel.h"

namespace lumi::wasm
{
namespace
{

constexpr int32_t kSpanPx = 8;  // what the planner's frame rates are for
constexpr uint32_t kModes = 3;

LUMI_CONSTANT Field field;
LUMI_CONSTANT Camera camera;

template <class Texel, class Pixel>
RenderError draw_as(const Style& style, const Stripe& stripe)
{
    if (!fits_spans(field)) return render<Linear, Texel, Pixel>(field, camera, style.background, stripe);
    if (style.mode == 0) return render<Paper<>, Texel, Pixel>(field, camera, style.background, stripe);
    if (style.mode == 1) return render_spans<Linear, Texel, Pixel>(field, camera, style.background, stripe, kSpanPx);
    return render_spans<Nearest, Texel, Pixel>(field, camera, style.background, stripe, kSpanPx);
}

}  // namespace

ViewError open_drawing(const uint8_t* bytes, size_t size)
{
    return detail::view_error(open_field(bytes, size, field));
}

void set_part(uint32_t, uint32_t) {}

void set_state_weight(uint32_t, const StateWeight&) {}

PartSigns part_signs(uint32_t)
{
    return {};
}

uint32_t drawing_modes()
{
    return kModes;
}

uint32_t drawing_bytes(int32_t, int32_t)
{
    return 0;
}

uint32_t device_bytes(const host::ScreenSize&, uint32_t, DisplayFormat)
{
    return host::chord_view_bytes(fits_spans(field));
}

ViewError look(const Pose& pose, const Image& image, const Style&, uint8_t*)
{
    return detail::view_error(make_camera(pose, image, camera));
}

ViewError draw(const Style& style, const Stripe& stripe)
{
    const RenderError error = detail::with_texel(field.texel_format, [&](auto texel) {
        return with_pixel(style.format,
                          [&](auto pixel) { return draw_as<decltype(texel), decltype(pixel)>(style, stripe); });
    });
    return error == RenderError::none ? ViewError::none : ViewError::other_renderer;
}

}  // namespace lumi::wasm
