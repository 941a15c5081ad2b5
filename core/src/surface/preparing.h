// SPDX-License-Identifier: MIT
// The steps of preparing a frame, for any part of a field's vertices and patches.
#pragma once

#include "lumi/surface/halves.h"
#include "surface/bands.h"

namespace lumi::detail
{

inline constexpr PlaceRange kNoPlace = {INT32_MAX, INT32_MIN};
inline constexpr PlacedVertices kNoneIsPlaced = {kNoPlace, kNoPlace, true};

inline void empty_bands(const SurfaceFrame& frame, uint16_t* bands)
{
    for (uint32_t k = 0; k <= frame.other_list; ++k) bands[k] = kEmptyBand;
}

// The frame's constants, and lists without triangles; false if the sphere lies behind the near plane, so that nothing
// of it shows.
bool begin_frame(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode, const SurfaceMemory& memory,
                 SurfaceFrame& out);

// Places these vertices, without their light.
PlacedVertices put_vertices(const SurfaceFrame& frame, uint32_t begin, uint32_t end);

// After all vertices.
void set_extents(SurfaceFrame& frame, const PlacedVertices& placed);

}  // namespace lumi::detail
