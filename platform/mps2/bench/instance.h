// SPDX-License-Identifier: MIT
// The renderer under test: each bench program links exactly one.
#pragma once

#include "lumi/chord/render.h"

namespace lumi::bench
{

// Draws a stripe of RGB565 pixels. `span_px` is 0 for what has no spans.
RenderError draw(const Field& field, const Camera& camera, const Stripe& stripe, int32_t span_px);

// Draws as above, but a pixel's hits are only placed: what remains is the cost of set-up. The pixels hold nothing
// useful afterwards.
RenderError draw_setup_only(const Field& field, const Camera& camera, const Stripe& stripe, int32_t span_px);

}  // namespace lumi::bench
