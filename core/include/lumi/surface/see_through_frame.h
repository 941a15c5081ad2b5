// SPDX-License-Identifier: MIT
// Fields, memory and frames of see-through.h.
#pragma once
#pragma GCC system_header

#include "lumi/surface/frame.h"

namespace lumi
{

// A SurfaceField that holds its opaque patches, and see-through ones behind them in the same memory.
struct SeeThroughField : SurfaceField {
    const uint8_t* see_through_palette = nullptr;  // 256 × (r, g, b added, r, g, b passed)
    uint16_t see_through_count = 0;                // patches; 0: none, and no palette
    bool is_in_order = false;                      // patches are drawn as they stand in the file, not by depth
};

// Opens a file as open_surface for a SurfaceField does, with see-through parts or without.
FieldError open_surface(const uint8_t* bytes, size_t size, SeeThroughField& out);

// Numbers in SeeThroughMemory::order for a field with so many see-through patches.
constexpr uint32_t see_through_order(uint32_t see_through_patches)
{
    return 2 * see_through_patches;
}

// The caller's memory for a frame; see SurfaceMemory.
struct SeeThroughMemory : SurfaceMemory {
    uint32_t* order;  // see_through_order()
};

struct SeeThroughFrame : SurfaceFrame {
    const uint32_t* order;  // src/surface/order.h
    uint32_t order_count;
    detail::PackedColour added_and_passed[512];  // 256 each; PackedColour, but what passes has no fraction for rounding
};

}  // namespace lumi

namespace lumi::detail
{

// Lists the triangles that face the eye, in the field's order, and lights them. After prepare().
void put_see_through(const SeeThroughField& field, uint32_t* order, SeeThroughFrame& frame);

// Returns share·c of each channel. Shares are in 1/1024, less one of them so that ten bits hold it; those of blue are
// in 1/512.
LUMI_ALWAYS_INLINE PackedColour share_of(PackedColour shares, PackedColour c)
{
    const uint32_t g = ((shares >> 21) + 1) * (c >> 21) >> 10;
    const uint32_t r = (((shares >> 10) & 0x3FF) + 1) * ((c >> 10) & 0x3FF) >> 10;
    const uint32_t b = ((shares & 0x1FF) + 1) * (c & 0x1FF) >> 9;
    return g << 21 | r << 10 | b;
}

// How much of what lies behind passes, 0 .. 255 a channel, as share_of() takes it.
constexpr PackedColour packed_shares(const uint8_t* passed)
{
    // v · 1023/255 and v · 511/255, rounded.
    const auto ten = [](uint32_t v) { return 4 * v + quotient<255, 3 * 255 + 127>(3 * v + 127); };
    const auto nine = [](uint32_t v) { return 2 * v + quotient<255, 255 + 127>(v + 127); };
    return ten(passed[1]) << 21 | ten(passed[0]) << 10 | nine(passed[2]);
}

// Fills the frame's palette: what lies behind brings its share of the rounding that palette_colour()
// adds, so what is added brings the rest.
template <class Pixel>
void put_see_through_palette(const SeeThroughField& field, SurfaceMode mode, SeeThroughFrame& frame)
{
    constexpr PackedColour kBlack = palette_colour<Pixel>({0, 0, 0});
    const bool has_halves = mode == SurfaceMode::antialiased;
    const uint8_t* entry = field.see_through_palette;
    for (uint32_t k = 0; k < format::kPaletteEntries; ++k, entry += format::see_through::kEntryBytes) {
        const PackedColour passed = packed_shares(entry + 3);
        const PackedColour added = palette_colour<Pixel>({entry[0], entry[1], entry[2]}) - share_of(passed, kBlack);
        frame.added_and_passed[k] = has_halves ? mean_of(added, 0) : added;
        frame.added_and_passed[k + format::kPaletteEntries] = has_halves ? mean_of(passed, 0) : passed;
    }
}

// After the opaque triangles were prepared.
template <class Pixel>
void add_see_through(const SeeThroughField& field, const SeeThroughMemory& memory, SeeThroughFrame& out)
{
    out.order = memory.order;
    put_see_through(field, memory.order, out);
    if (field.see_through_count != 0) put_see_through_palette<Pixel>(field, out.mode, out);
}

}  // namespace lumi::detail

namespace lumi
{

template <class Pixel, SurfaceMode kFinest = SurfaceMode::two_by_two, bool = true>
void prepare_surface(const SeeThroughField& field, const SurfaceCamera& camera, SurfaceMode mode,
                     const SeeThroughMemory& memory, SeeThroughFrame& out)
{
    const SurfaceField& opaque = field;
    const SurfaceMemory& of_opaque = memory;
    SurfaceFrame& frame = out;
    prepare_surface<Pixel, kFinest>(opaque, camera, mode, of_opaque, frame);
    detail::add_see_through<Pixel>(field, memory, out);
}

}  // namespace lumi
