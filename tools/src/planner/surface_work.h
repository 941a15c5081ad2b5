// SPDX-License-Identifier: MIT
// Counts the work of a frame of a surface field while it is drawn: its triangles go through core's own steps, stripe
// by stripe.
#pragma once

#include <array>
#include <cstddef>

#include "draw/views.h"
#include "lumi/surface/frame.h"

namespace lumi::planner
{

enum class SurfaceItem : size_t {
    frame,           // 1
    vertex,          // all in the field
    patch,           // opaque ones in the field
    listed,          // triangles that face the eye and reach samples
    cornered,        // vertices of these
    lit,             // those that have view tables
    bordered,        // patches whose outlines are looked for
    image_px,        // pixels of the image
    part_px,         // stripes have them, with what they draw beside them, where the surface may be
    stripe,          // stripes
    visited,         // triangles that lists offer to stripes
    boxed,           // those whose boxes have samples
    looked_at,       // samples that are compared to know whether all of a box are hidden
    begun,           // triangles, and parts of large ones, whose rows are set up
    large,           // large triangles, in every stripe
    parts,           // parts of these that are begun
    halved,          // so many are looked at to make these, nearly
    loop,            // calls of loops over rows
    wide,            // parts of wide triangles, whose colour is set anew
    wide_looked_at,  // triangles that are long enough to have such parts
    row,             // rows, empty ones too
    filled,          // rows that have samples
    sample,          // samples
    shown,           // those that are nearer than what was there
    magnified_loop,  // as above, where textures are read bilinearly
    magnified_row,
    magnified_filled,
    magnified_sample,
    magnified_shown,
    rim,            // those of them that lie at the rim of their texels
    clamped,        // samples that are brighter than white or darker than black
    blended,        // those of them whose four texels differ
    outline,        // triangles with outlines, in every stripe
    edge,           // their outlines
    line,           // lines of samples that these cross
    marked,         // pixels that they cut
    marked_row,     // rows of pixels that may have some
    whole_px,       // pixels of four samples: all with a surface
    apart_px,       // those of them whose light is averaged
    mixed_px,       // some
    see_frame,      // 1 where there are any see-through triangles
    see_sample_px,  // samples of stripes whose colours are filled beforehand
    see_patch,      // see-through patches
    ordered,        // see-through triangles that show
    sorted,         // these times the logarithm of their number
    see_visited,    // these in every stripe
    see_boxed,
    see_looked_at,
    see_begun,
    see_loop,
    see_row,
    see_filled,
    see_sample,
    see_shown,
    see_alone,  // samples that blend over the background
    see_magnified_sample,
    see_magnified_shown,
    see_rim,
    see_clamped,
    see_blended,  // those whose four texels differ
    see_line,
    kCount
};
inline constexpr size_t kSurfaceItems = static_cast<size_t>(SurfaceItem::kCount);

// In that order.
// clang-format off
inline constexpr std::array<const char*, kSurfaceItems> kSurfaceItemNames = {
    "frame", "vertex", "patch", "listed", "cornered", "lit", "bordered", "image_px", "part_px", "stripe", "visited",
    "boxed", "looked_at", "begun", "large", "parts", "halved", "loop", "wide", "wide_looked_at", "row", "filled",
    "sample", "shown", "magnified_loop", "magnified_row", "magnified_filled", "magnified_sample", "magnified_shown",
    "rim", "clamped", "blended", "outline", "edge", "line", "marked", "marked_row", "whole_px", "apart_px",
    "mixed_px", "see_frame", "see_sample_px", "see_patch", "ordered", "sorted", "see_visited", "see_boxed",
    "see_looked_at", "see_begun", "see_loop", "see_row", "see_filled", "see_sample", "see_shown", "see_alone",
    "see_magnified_sample", "see_magnified_shown", "see_rim", "see_clamped", "see_blended", "see_line"};
// clang-format on
static_assert(kSurfaceItemNames.back() != nullptr, "each item has a name");

struct SurfaceWork {
    std::array<double, kSurfaceItems> count{};

    double& operator[](SurfaceItem item) { return count[static_cast<size_t>(item)]; }
    double operator[](SurfaceItem item) const { return count[static_cast<size_t>(item)]; }
};

// Counts a frame of RGB565 over black, in stripes of so many scanlines.
SurfaceWork work_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows);

}  // namespace lumi::planner
