// SPDX-License-Identifier: MIT
// Either surface_drawing.cpp or chord_drawing.cpp draws a field for the viewer. A module links one of them, as a
// firmware does, so a page carries only the code of its own field.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "lumi/background.h"
#include "lumi/camera.h"
#include "lumi/color.h"
#include "lumi/host/view_memory.h"
#include "lumi/pixel.h"
#include "lumi/stripe.h"
#include "lumi/view_error.h"

// For variables: the linker would run what constructs them at each call of an export.
#define LUMI_CONSTANT [[clang::require_constant_initialization]]

namespace lumi::wasm
{

inline constexpr int32_t kStripeRows = 16;  // as `lumi render` draws, and firmware with some kilobytes to spare

// The values are those of the page's script.
enum class DisplayFormat : uint32_t { rgb888, rgb565, grey8 };
inline constexpr uint32_t kDisplayFormats = 3;

// Calls `next` with a value of the display's pixel policy. In the module of <lumi-view>, LUMI_VIEW_ELEMENT, that is
// one, drawn over nothing: the page shows around the object.
template <class Next>
auto with_pixel([[maybe_unused]] DisplayFormat format, const Next& next)
{
#ifdef LUMI_VIEW_ELEMENT
    return next(PixelArgb8888());
#else
    if (format == DisplayFormat::rgb565) return next(PixelRgb565());
    if (format == DisplayFormat::grey8) return next(PixelGrey8());
    return next(PixelRgb888());
#endif
}

// How a frame is drawn. What a mode's number means is the drawing's own: `kModes` of its file.
struct Style {
    uint32_t mode;
    DisplayFormat format;
    OverColour background;

#ifdef LUMI_VIEW_ELEMENT
    OverNothing behind() const
    {
        return {};
    }
#else
    const OverColour& behind() const
    {
        return background;
    }
#endif
};

// A failure leaves what was open.
ViewError open_drawing(const uint8_t* bytes, size_t size);
uint32_t drawing_modes();

// From the next look() on a moving part is there: turns times 2^32, or radii, Q20, of one that slides. A number of no
// part counts for nothing.
void set_part(uint32_t part, uint32_t value);

// A moving part's name, in the field, and whether it slides; no name: there is no such part.
struct PartSigns {
    const char* name;
    uint32_t name_bytes;
    bool slides;
};
PartSigns part_signs(uint32_t part);

// From the next look() on so much of a light state shows, or a tint has this colour. A number of no state counts for
// nothing.
void set_state_weight(uint32_t state, const StateWeight& weight);

// Bytes of memory that look() takes for images of that size, whatever the style.
uint32_t drawing_bytes(int32_t width_px, int32_t height_px);

// Bytes of the view with which a firmware draws the field, without its stripe of pixels.
uint32_t device_bytes(const host::ScreenSize& screen, uint32_t mode, DisplayFormat format);

// Prepares a frame in `memory`, of drawing_bytes(), at an address divisible by 8. Preconditions: a field is open,
// style.mode < drawing_modes().
ViewError look(const Pose& pose, const Image& image, const Style& style, uint8_t* memory);

// Draws a stripe of the frame, of full width and at most kStripeRows rows, in the style's format.
ViewError draw(const Style& style, const Stripe& stripe);

// The module's memory behind its own data (memory.cpp) is given out in one region after another.
inline constexpr size_t kAlignment = 8;

// A region of so many bytes at a multiple of kAlignment, or null where the browser has no more. Its bytes are not
// cleared.
uint8_t* reserve(size_t bytes);

// Gives back `region` and all that was reserved after it; null: everything.
void release_from(const uint8_t* region);

}  // namespace lumi::wasm
