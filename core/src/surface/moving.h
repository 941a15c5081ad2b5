// SPDX-License-Identifier: MIT
// One core and two prepare moving parts by these.
#pragma once

#include "lumi/surface/parts.h"
#include "surface/owners.h"
#include "surface/preparing.h"

namespace lumi::detail
{

// A vertex of a part may lie outside the sphere, whatever its record says. What lies behind the sphere counts as at its
// far end, and what lies far to the side as there: sums of two numbers of 30 bits, with a bit to spare.
LUMI_ALWAYS_INLINE ViewPoint moved_point(const SurfaceProjection& p, const VertexQ14& v)
{
    constexpr int32_t kMost = (1 << 30) + (1 << 20);
    const auto bounded = [](int32_t c) { return c < -kMost ? -kMost : c < kMost ? c : kMost; };
    const ViewPoint at = view_point(p, v);
    return {bounded(at.x), bounded(at.y), at.z < p.far_z ? at.z : p.far_z};
}

// An owner may have no vertices: differences of these fit 32 bits, too.
inline constexpr PlaceRange kNoPlaceYet = {1 << 30, -(1 << 30)};
inline constexpr PlacedVertices kNothingPlaced = {kNoPlaceYet, kNoPlaceYet, true};

// The corners of a cut triangle of a part are where the part is.
void place_cut(const SurfaceFrame& frame, CutTriangle& cut);

// Adds these vertices to what was placed.
void place_vertices(const SurfaceFrame& frame, const NumberRange& vertices, PlacedVertices& placed);

}  // namespace lumi::detail
