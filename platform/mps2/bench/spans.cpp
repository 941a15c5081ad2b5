// SPDX-License-Identifier: MIT
// The span renderer with the policies that the build names: LUMI_BENCH_RECONSTRUCTION, LUMI_BENCH_TEXEL.
#include "instance.h"
#include "lumi/bench/views.h"
#include "lumi/chord/render_spans.h"

namespace lumi::bench
{

RenderError draw(const Field& field, const Camera& camera, const Stripe& stripe, int32_t span_px)
{
    return render_spans<LUMI_BENCH_RECONSTRUCTION, LUMI_BENCH_TEXEL, PixelRgb565>(field, camera, kBackground, stripe,
                                                                                  span_px);
}

}  // namespace lumi::bench
