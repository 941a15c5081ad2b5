// SPDX-License-Identifier: MIT
// The paper's algorithm in floating point, with or without a floating-point unit as the build's flags say.
#include "instance.h"
#include "lumi/bench/float_paper.h"

namespace lumi::bench
{

RenderError draw(const Field& field, const Camera& camera, const Stripe& stripe, int32_t)
{
    draw_float_paper<LUMI_BENCH_TEXEL, PixelRgb565>(field, camera, stripe);
    return RenderError::none;
}

}  // namespace lumi::bench
