// SPDX-License-Identifier: MIT
// A rectangle of samples in the caller's memory: row after row, a row's depths and then its colours. Colours are pixels
// where a pixel is one sample in 5, 6 and 5 bits, so that a row of them is copied as it is; else they are PackedColour.
// Bits for each sample mark what an outline cuts (marks.h).
#pragma once

#include "lumi/pixel.h"
#include "lumi/surface/detail/packed_colour.h"

namespace lumi::detail
{

// Whether samples of one-sample modes hold pixels of a format.
template <class Pixel>
inline constexpr bool kIsSample = kPacks565<Pixel>;

inline constexpr uint32_t kMarkPlanes = 3;

// Samples that triangles are drawn into, and how.
struct Target {
    uint8_t* first;       // the depth of the first sample
    uint32_t row_bytes;   // from row to row
    uint32_t colours_at;  // from a row's first depth to its first colour, bytes
    int32_t width, height;
    uint32_t* marks;  // kMarkPlanes of marks_words() a row, after the rows; null: no outlines
    int32_t x, y;     // where the first sample lies on the frame's grid
    const PackedColour* palette;
    bool has_two_taps;  // a texel is the sum of two, a quarter texel away on either side; the palette has halves
    // Textures that change by no more than so much of a texel a sample are read bilinearly; negative: none.
    int32_t magnified_q10;

    uint8_t* row(int32_t line) const { return first + static_cast<uint32_t>(line) * row_bytes; }
    uint16_t* depths(int32_t line) const { return reinterpret_cast<uint16_t*>(row(line)); }
    template <class Colour>
    Colour* colours(int32_t line) const
    {
        return reinterpret_cast<Colour*>(row(line) + colours_at);
    }
    uint32_t marks_words() const { return (static_cast<uint32_t>(width) + 31) / 32; }
};

constexpr uint32_t even(uint32_t v)
{
    return (v + 1) & ~1u;
}

// Bytes of a row of samples, `colour_bytes` each for the colours, a multiple of 4. A row of pixels may begin a sample
// late, so that a stripe's first pixel has a place like its own.
constexpr uint32_t sample_row_bytes(uint32_t width, uint32_t colour_bytes)
{
    return (static_cast<uint32_t>(sizeof(uint16_t)) + colour_bytes) * even(width + (colour_bytes == 2 ? 1 : 0));
}

constexpr uint32_t sample_bytes(uint32_t width, uint32_t height, uint32_t colour_bytes, bool has_marks)
{
    return height * (sample_row_bytes(width, colour_bytes) + (has_marks ? kMarkPlanes * 4 * ((width + 31) / 32) : 0));
}

}  // namespace lumi::detail
