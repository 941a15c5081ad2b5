// SPDX-License-Identifier: MIT
// What a stripe takes of the samples, and what is done with all of them at once.
#pragma once

#include "lumi/surface/detail/pieces.h"

namespace lumi::detail
{

// After draw_triangles: marks the pixels that outlines cut, where the rows have marks and these are clear.
LUMI_HOT void mark_outlines(const SurfaceFrame& frame, const Target& target);

struct SampleRect {
    int32_t x_px, y_px, width_px, height_px;  // within the image
};

// The pixels of a stripe that the surface may cover, and those whose samples they take: with outlines one more on every
// side, as far as there are any.
struct DrawnPart {
    int32_t left_px, right_px, top_px, bottom_px;
    SampleRect rect;
    bool is_odd;  // its first sample has an odd column in the stripe

    bool is_empty() const { return left_px >= right_px || top_px >= bottom_px; }
};
DrawnPart drawn_part(const SurfaceFrame& frame, const Stripe& stripe);

// The samples of a rectangle in the caller's memory. With samples that are pixels, their place in a word is that of
// the stripe's, if the stripe's first pixel lies at the start of one.
SampleRows samples_of(const SurfaceFrame& frame, const DrawnPart& part, bool are_pixels, void* memory);

// Sets the depths of all samples to kEmptyDepth and clears their marks.
LUMI_HOT void clear_depths(const SampleRows& rows);
// The same, and sets the colours of samples that are pixels.
LUMI_HOT void clear_pixels(const SampleRows& rows, uint16_t pixel);
// Copies pixels; best where both lie equally in a word.
LUMI_HOT void copy_pixels(uint8_t* to, const uint8_t* from, uint32_t count);

// Texels larger than so many pixels are read bilinearly in modes that do so.
inline constexpr int32_t kMagnifiedPx = 3;

inline Target target_of(const SurfaceFrame& frame, const DrawnPart& part, const SampleRows& rows)
{
    const uint32_t log2 = frame.samples_log2;
    return {rows,
            part.rect.x_px << log2,
            part.rect.y_px << log2,
            frame.palette,
            frame.mode == SurfaceMode::antialiased,
            frame.mode == SurfaceMode::one_sample ? -1 : (1024 / kMagnifiedPx) >> log2};
}

}  // namespace lumi::detail
