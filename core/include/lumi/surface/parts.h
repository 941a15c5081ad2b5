// SPDX-License-Identifier: MIT
// Parts of a surface field that move: a part turns about its axis, or slides along it, to the value that was set last
// when a frame is prepared. The body keeps its vertices, lists and light while eye and mode stay the same.
//
//     turn_part(field, memory, 0, degrees(90));                // memory: of SurfaceFrame, with feature_words()
//     prepare_surface<PixelRgb565, kFinest, SurfaceFeatures::all>(field, camera, mode, memory, frame);
//     const ChangedRects changed = changed_rects(frame);       // what a display must be sent
//
// A point x of a part goes to R(x - c) + c + s·a, where a is its axis, c a point of the axis, R the turn and s the
// offset. So a part is projected by the body's axes turned by the inverse of R, and its view tables are read for an eye
// that is moved by the inverse, unless the part turns below its light. Depths are the body's.
#pragma once
#pragma GCC system_header

#include "lumi/surface/frame.h"

namespace lumi::detail
{

// Holds a rectangle of the image; left == right: nothing.
struct PixelBounds {
    uint16_t left, top, right, bottom;
};

struct SurfacePart {
    SurfaceProjection projection;
    uint32_t value;  // the next frame's: turns32, or an offset in Q20
    PixelBounds shown, shown_before;
};

// All parts of a frame share this; their own numbers lie behind it. All of it is 0 before the first frame.
struct SurfaceParts {
    PixelBounds body;    // where the body shows
    PixelBounds before;  // where the frame before showed anything
    uint16_t moved;      // bit k: part k has moved since then
    uint8_t reach;       // SurfaceFrame::reach of the body
    bool has_frame : 1, has_body : 1, keeps_body : 1;
};
static_assert((sizeof(SurfaceParts) + 16 * sizeof(SurfacePart)) == 4 * part_words(16), "part_words counts them");
static_assert(sizeof(SurfaceParts) + sizeof(SurfacePart) <= 160, "the RAM of a part");

inline SurfaceParts& moving_parts(const SurfaceField& field, const SurfaceMemory& memory)
{
    return *reinterpret_cast<SurfaceParts*>(memory.features + see_through_words(field.see_through_count));
}

inline SurfacePart& moving_part(SurfaceParts& parts, uint32_t k)
{
    return reinterpret_cast<SurfacePart*>(&parts + 1)[k];
}

// Puts memory for parts into the state that it has before the first frame: all parts rest.
void rest_parts(const SurfaceField& field, const SurfaceMemory& memory);

}  // namespace lumi::detail

namespace lumi
{

// Turn or slide a part in the next frame that is prepared. The value is clamped to the part's range: an angle to the
// nearer end. Return false if there is no such part, or if it moves in the other way.
bool turn_part(const SurfaceField& field, const SurfaceMemory& memory, uint32_t part, uint32_t turns32);
bool slide_part(const SurfaceField& field, const SurfaceMemory& memory, uint32_t part, int32_t offset_q20);

// Tells what has changed since the frame before, in rectangles whose sides are multiples of `align` as far as the image
// reaches. If the eye or the mode has changed, that is where either frame shows anything; at first it is the image.
ChangedRects changed_rects(const SurfaceFrame& frame, uint32_t align_x = 1, uint32_t align_y = 1);

}  // namespace lumi
