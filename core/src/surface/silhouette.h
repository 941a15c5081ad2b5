// SPDX-License-Identifier: MIT
// Smooth outlines from one sample a pixel: the pixels along an edge of the mesh whose other side is turned away are
// marked with the share of them that the edge cuts off (Persson, "Geometric Post-process Anti-Aliasing", 2011).
#pragma once

#include "surface/fill.h"

namespace lumi::detail
{

// Marks the pixels of an edge, after all triangles are filled; see lumi/surface/detail/marks.h. The edge lies on a
// triangle that is counter-clockwise on the screen, in its order.
LUMI_HOT void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to, const Target& target);

}  // namespace lumi::detail
