// SPDX-License-Identifier: MIT
// The exact renderer without lattice and texels: hits are computed and thrown away.
#pragma once

#include "lumi/bench/views.h"
#include "lumi/chord/render.h"

namespace lumi::bench
{

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
