// SPDX-License-Identifier: MIT
// Smooth outlines from one sample a pixel: the pixels along an edge of the mesh whose other side is turned away are
// blended by the share of them that the edge cuts off (Persson, "Geometric Post-process Anti-Aliasing", 2011).
#pragma once

#include "surface/fill.h"

namespace lumi::surfaces
{

// After all triangles are filled. A pixel over the background keeps its colour and has its coverage in place of its
// depth, in 1/256: 1 .. 255. The edge lies on a triangle that is counter-clockwise on the screen, in its order.
void blend_edge(const SurfaceVertex& from, const SurfaceVertex& to, uint32_t one_surface, const Target& target);

}  // namespace lumi::surfaces
