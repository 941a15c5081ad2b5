// SPDX-License-Identifier: MIT
// Counts the work of a frame of a chord field: the pieces that core cuts its stripes into, and the lattice points that
// its pixels read.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "draw/draw.h"
#include "lumi/chord/render_spans.h"
#include "lumi/host/view_memory.h"
#include "planner/chips.h"

namespace lumi::planner
{

enum class ChordItem : size_t {
    frame,        // 1
    image_px,     // pixels of the image
    pixel,        // those that the sphere covers
    scanline,     // scanlines that the sphere covers
    band,         // bands of scanlines as high as tiles that it covers
    tile,         // tiles
    wide_tile,    // those of 16 pixels
    narrow_tile,  // those of 8 where one of 16 has its place
    missed_tile,  // places between tiles where none can be
    zone,         // pieces whose lattice lies in another zone than before, of either side
    capped,       // pieces of fields that keep only some origins
    tile_line,    // scanlines of tiles
    tile_pixel,   // their pixels
    gap,          // begins of spans that do not follow another one
    span,         // spans through cells
    span_pixel,   // their pixels
    lone,         // spans of one pixel
    mixed,        // pieces with cells of either diagonal
    mixed_line,   // their scanlines
    mixed_pixel,
    lone_line,    // scanlines of tiles that Linear's loop does not take at once
    steep_pixel,  // pixels of scanlines whose steps are too long for it
    checked,      // spans whose texels are checked
    cell_pixel,   // their pixels through cells, of either side
    pole_pixel,   // those over a pole
    polar_side,   // pieces over a pole, of either side
    checked_row,  // origins that these read and that are baked
    cap_side,     // sides of exact pixels so near a pole that points there are all looked at
    pole_side,    // those in a polar region
    blend_side,   // those at its border
    zone_step,    // zones that are looked at for them
    row,          // origins that pixels read
    tap_rgb888,   // texels that they read, by format
    tap_rgb565,
    tap_palette8,
    tap_luma8,
    clear,       // pixels whose nearest ray misses the scene
    half_clear,  // those that partly do
    shown,       // the others
    few_side,    // sides of exact pixels whose lattice has so few points that all are looked at
    few_point,   // these points
    made_zone,   // zones that stripes set up, of either side
    searched,    // scanlines whose outline does not follow from the one before
    shortened,   // spans that were first tried longer
    kCount
};
inline constexpr size_t kChordItems = static_cast<size_t>(ChordItem::kCount);

// In that order.
// clang-format off
inline constexpr std::array<const char*, kChordItems> kChordItemNames = {
    "frame", "image_px", "pixel", "scanline", "band", "tile", "wide_tile", "narrow_tile", "missed_tile", "zone",
    "capped", "tile_line", "tile_pixel", "gap", "span", "span_pixel", "lone", "mixed", "mixed_line",
    "mixed_pixel", "lone_line", "steep_pixel", "checked", "cell_pixel", "pole_pixel", "polar_side", "checked_row",
    "cap_side", "pole_side", "blend_side", "zone_step", "row", "tap_rgb888",
    "tap_rgb565", "tap_palette8", "tap_luma8", "clear", "half_clear", "shown", "few_side", "few_point",
    "made_zone", "searched", "shortened"};
// clang-format on
static_assert(kChordItemNames.back() != nullptr, "each item has a name");

struct ChordWork {
    std::array<double, kChordItems> count{};

    double& operator[](ChordItem item) { return count[static_cast<size_t>(item)]; }
    double operator[](ChordItem item) const { return count[static_cast<size_t>(item)]; }
};

struct ChordFrame {
    ChordWork work;
    std::vector<Read> reads;  // in the order of drawing; addresses count from the first texel
};

// Whether a field is drawn by spans; else every pixel is drawn exactly, whatever span is asked for.
inline bool is_drawn_by_spans(const Field& field, tools::Mode mode, int32_t span_px)
{
    return span_px != 0 && mode != tools::Mode::paper && fits_spans(field);
}

// Counts a frame in stripes over black. span_px: 4, 8 or 16, or 0 for exact pixels.
ChordFrame frame_of(const Field& field, tools::Mode mode, int32_t span_px, const Camera& camera,
                    const host::ScreenSize& screen);

}  // namespace lumi::planner
