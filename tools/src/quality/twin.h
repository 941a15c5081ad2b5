// SPDX-License-Identifier: MIT
// Pictures by the double-precision twin of the renderer of surface fields.
#pragma once

#include "draw/draw_surface.h"

namespace lumi::quality
{

// `file`: the bytes of an intact surface field. SurfaceMode::antialiased is drawn with four samples.
tools::Picture draw_twin(const uint8_t* file, const tools::Eye& eye, SurfaceMode mode, const Rgb8& background);

}  // namespace lumi::quality
