// SPDX-License-Identifier: MIT
// The steps of preparing a frame, for any part of a field's vertices. Inlined: what prepares on one core has no calls
// for the sake of two.
#pragma once

#include "lumi/surface/halves.h"
#include "surface/bands.h"
#include "surface/seen.h"

namespace lumi::detail
{

inline constexpr PlaceRange kNoPlace = {INT32_MAX, INT32_MIN};
inline constexpr PlacedVertices kNoneIsPlaced = {kNoPlace, kNoPlace, true};

inline void empty_bands(const SurfaceFrame& frame, uint16_t* bands)
{
    for (uint32_t k = 0; k <= frame.other_list; ++k) bands[k] = kEmptyBand;
}

LUMI_ALWAYS_INLINE void add(PlaceRange& range, int32_t v)
{
    if (v < range.least) range.least = v;
    if (v > range.most) range.most = v;
}

// The pixels that a range of places in 1/64 sample meets, of `size`, and those beside them that an outline may change.
inline Extent pixels_of(const PlaceRange& q6, uint32_t samples_log2, int32_t size)
{
    if (q6.least > q6.most) return {0, 0};
    const auto within = [&](int32_t v) { return v < 0 ? 0 : v < size ? v : size; };
    const uint32_t shift = 6 + samples_log2;
    return {within((q6.least >> shift) - 1), within((q6.most >> shift) + 2)};
}

// The frame's constants, and lists without triangles; false if the sphere lies behind the near plane, so that nothing
// of it shows.
LUMI_ALWAYS_INLINE bool begin_frame(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                                    const SurfaceMemory& memory, SurfaceFrame& out)
{
    out.field = field;
    out.memory = memory;
    out.width_px = camera.width_px;
    out.height_px = camera.height_px;
    out.mode = mode;
    out.samples_log2 = mode == SurfaceMode::two_by_two ? 1 : 0;
    out.margin = mode == SurfaceMode::antialiased && field.neighbours != nullptr ? 1 : 0;
    out.other_list = surface_bands(out.height_px, memory.band_log2) - 1;
    empty_bands(out, memory.bands);
    out.reach = 0;
    out.columns = out.scanlines = {0, 0};
    return set_projection(camera, out);
}

// Places these vertices, without their light.
LUMI_ALWAYS_INLINE PlacedVertices put_vertices(const SurfaceFrame& frame, uint32_t begin, uint32_t end,
                                               uint32_t colour = kUnlit)
{
    PlacedVertices placed = kNoneIsPlaced;
    for (uint32_t k = begin; k < end; ++k) {
        const SamplePoint p = projected(frame.projection, view_point(frame.projection, surface_vertex(frame.field, k)));
        frame.memory.vertices[k] = packed(p, colour);
        placed.are_whole = placed.are_whole && p.depth != 0;
        add(placed.x_q6, p.x_q6);
        add(placed.y_q6, p.y_q6);
    }
    return placed;
}

// After all vertices.
LUMI_ALWAYS_INLINE void set_extents(SurfaceFrame& frame, const PlacedVertices& placed)
{
    constexpr int32_t kNarrowQ6 = 46340;  // twice a triangle's area, at most its width times its height, fits 32 bits
    const PlaceRange &x = placed.x_q6, &y = placed.y_q6;
    frame.is_whole = placed.are_whole;
    frame.is_narrow = x.most - x.least < kNarrowQ6 && y.most - y.least < kNarrowQ6;
    frame.columns = placed.are_whole ? pixels_of(x, frame.samples_log2, frame.width_px) : Extent{0, frame.width_px};
    frame.scanlines = placed.are_whole ? pixels_of(y, frame.samples_log2, frame.height_px) : Extent{0, frame.height_px};
}

}  // namespace lumi::detail
