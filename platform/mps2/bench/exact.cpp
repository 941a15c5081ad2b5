// SPDX-License-Identifier: MIT
// The exact renderer with the policies that the build names: LUMI_BENCH_RECONSTRUCTION, LUMI_BENCH_TEXEL.
#include "instance.h"
#include "lumi/bench/views.h"

namespace lumi::bench
{

RenderError draw(const Field& field, const Camera& camera, const Stripe& stripe, int32_t)
{
    return render<LUMI_BENCH_RECONSTRUCTION, LUMI_BENCH_TEXEL, PixelRgb565>(field, camera, kBackground, stripe);
}

}  // namespace lumi::bench
