// SPDX-License-Identifier: MIT
// The renderer under test: each bench program links exactly one.
#pragma once

#include "lumi/bench/views.h"
#include "lumi/chord/render.h"

namespace lumi::bench
{

// Draws a stripe of RGB565 pixels. `span_px` is 0 for what has no spans.
RenderError draw(const Field& field, const Camera& camera, const Stripe& stripe, int32_t span_px);

// Draws as above, but a pixel's hits are only placed: what remains is the cost of set-up. The pixels hold nothing
// useful afterwards.
RenderError draw_setup_only(const Field& field, const Camera& camera, const Stripe& stripe, int32_t span_px);

// The exact renderer without lattice and texels: hits are computed and thrown away.
struct NoReconstruction {
    static constexpr uint32_t kTaps = 1;
    static detail::Taps<kTaps> taps(const detail::Lattice&, const Vec3q30& direction)
    {
        __asm volatile("" ::"r"(direction.x), "r"(direction.y), "r"(direction.z));  // someone wants the hit
        return {1, {0}, {0}};
    }
};

struct NoTexel {
    static constexpr TexelFormat kFormat = LUMI_BENCH_TEXEL::kFormat;
    static detail::Rgba8 load(const Field&, const uint8_t*, uint32_t) { return {}; }
};

inline RenderError draw_hits_only(const Field& field, const Camera& camera, const Stripe& stripe)
{
    return render<NoReconstruction, NoTexel, PixelRgb565>(field, camera, kBackground, stripe);
}

}  // namespace lumi::bench
