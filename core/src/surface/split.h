// SPDX-License-Identifier: MIT
#pragma once

#include "surface/fill.h"

namespace lumi::detail
{

// A triangle of the field with its texture.
struct MeshTriangle {
    uint32_t vertex[3];
    int32_t u_q8[3], v_q8[3];
    Texture texture;
};

// Fills a triangle that is not to be filled as a whole: it is large, some of it lies nearer than the near plane or
// beside the guard band, or comes so near that a texture's bend along an edge shows. Such edges are halved until their
// halves are none of this; what is left over at 1/65536 of an edge is not drawn. Neighbours halve an edge alike, to the
// bit, so no gap opens between them.
void fill_in_parts(const SurfaceFrame& frame, const MeshTriangle& triangle, const Target& target);

}  // namespace lumi::detail
