// SPDX-License-Identifier: MIT
// Triangles that are not to be drawn as a whole: large ones, those of which some lies nearer than the near plane or
// beside the guard band, or comes so near that a texture's bend along an edge shows. Such edges are halved until their
// halves are none of this; what is left over at 1/65536 of an edge is not drawn. Neighbours halve an edge alike, to the
// bit, so no gap opens between them.
#pragma once

#include "surface/fill.h"

namespace lumi::detail
{

void begin_parts(Parts& parts, const SurfaceFrame& frame, uint32_t triangle);
// Sets `corner`, and the parts' vertices that it names, to the next part that can be drawn as a whole; false after the
// last.
bool next_part(Parts& parts, const SurfaceFrame& frame, const Target& target, Corner (&corner)[3]);

}  // namespace lumi::detail
