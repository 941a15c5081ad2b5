// SPDX-License-Identifier: MIT
// This is the span renderer with empty loops.
#include "instance.h"
#include "lumi/bench/views.h"
#include "lumi/chord/render_spans.h"

namespace lumi
{
namespace bench
{

struct SetupOnly : LUMI_BENCH_RECONSTRUCTION {
};

}  // namespace bench

template <>
struct detail::SpanDraw<bench::SetupOnly> {
    template <class Texel, class Pixel, class Background>
    static void draw(detail::CellPiece<Background>& span)
    {
        int32_t scanlines_left = span.scanlines();
        span.go_to_first();
        do {
            __asm volatile("" ::"r"(&span) : "memory");  // someone wants the scanline
        } while (span.go_down(scanlines_left));
    }
    template <class Texel, class Pixel, class Background>
    static void draw_checked(const detail::CheckedPiece<Background>& span)
    {
        __asm volatile("" ::"r"(&span) : "memory");
    }
};

}  // namespace lumi

namespace lumi::bench
{

RenderError draw_setup_only(const Field& field, const Camera& camera, const Stripe& stripe, int32_t span_px)
{
    if (span_px <= 1) return draw_hits_only(field, camera, stripe);  // no spans: the exact renderer draws
    return render_spans<SetupOnly, LUMI_BENCH_TEXEL, PixelRgb565>(field, camera, kBackground, stripe, span_px);
}

}  // namespace lumi::bench
