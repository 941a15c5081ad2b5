// SPDX-License-Identifier: MIT
// Every combination of reconstruction × texel × pixel × background that core offers, and all of core's functions that
// firmware calls, for tests that read symbols and stack sizes. Never run.
#include "lumi/guided/focus_surface.h"
#include "lumi/guided/guided_render.h"
#include "lumi/guided/guided_vq.h"
#include "lumi/proxy/proxy_surface.h"
#include "lumi/render.h"
#include "lumi/render_spans.h"

namespace lumi::policies
{

using Render = RenderError (*)(const Field&, const Camera&, const void* background, const Stripe&);

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError draw(const Field& field, const Camera& camera, const void* background, const Stripe& stripe)
{
    return render<Reconstruction, Texel, Pixel>(field, camera, *static_cast<const Background*>(background), stripe);
}

// A reconstruction drawn by spans.
template <class Reconstruction>
struct BySpans;

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError draw_spans(const Field& field, const Camera& camera, const void* background, const Stripe& stripe)
{
    constexpr int32_t kSpanPx = 16;
    return render_spans<Reconstruction, Texel, Pixel>(field, camera, *static_cast<const Background*>(background),
                                                      stripe, kSpanPx);
}

template <class Reconstruction, class Texel, class Pixel>
struct OverEach {
    Render black = draw<Reconstruction, Texel, Pixel, OverBlack>;
    Render colour = draw<Reconstruction, Texel, Pixel, OverColour>;
    Render stripe = draw<Reconstruction, Texel, Pixel, OverStripe>;
};

template <class Reconstruction, class Texel, class Pixel>
struct OverEach<BySpans<Reconstruction>, Texel, Pixel> {
    Render black = draw_spans<Reconstruction, Texel, Pixel, OverBlack>;
    Render colour = draw_spans<Reconstruction, Texel, Pixel, OverColour>;
    Render stripe = draw_spans<Reconstruction, Texel, Pixel, OverStripe>;
};

template <class Reconstruction, class Texel>
struct EveryPixel {
    OverEach<Reconstruction, Texel, PixelRgb565> rgb565;
    OverEach<Reconstruction, Texel, PixelRgb565Swapped> rgb565_swapped;
    OverEach<Reconstruction, Texel, PixelRgb888> rgb888;
    OverEach<Reconstruction, Texel, PixelGrey8> grey8;
};

template <class Reconstruction>
struct EveryTexel {
    EveryPixel<Reconstruction, TexelRgb888> rgb888;
    EveryPixel<Reconstruction, TexelRgb565> rgb565;
    EveryPixel<Reconstruction, TexelPalette8> palette8;
    EveryPixel<Reconstruction, TexelLuma8> luma8;
};

// Of the paper's kernel the smallest, the default and the largest.
struct EveryReconstruction {
    EveryTexel<Nearest> nearest;
    EveryTexel<Linear> linear;
    EveryTexel<Paper<1>> paper1;
    EveryTexel<Paper<5>> paper5;
    EveryTexel<Paper<kMaxNeighbours>> paper9;
    EveryTexel<BySpans<Nearest>> nearest_spans;
    EveryTexel<BySpans<NearestVoronoi>> voronoi_spans;
    EveryTexel<BySpans<Dither>> dither_spans;
    EveryTexel<BySpans<Linear>> linear_spans;
    EveryTexel<BySpans<Paper<kMaxNeighbours>>> paper9_spans;
};

extern const EveryReconstruction kEveryPolicy;
const EveryReconstruction kEveryPolicy = {};

// Guided fields: the shading policies over each surface. What firmware holds between stripes is not on its stack.
struct GuidedView {
    GuidedField field;
    Camera camera;
    ProxyFrame frame;
    uint16_t* depths;
};
using RenderGuided = GuidedError (*)(const GuidedView&, const void* background, const Stripe&);

template <class Policy, class Pixel, class Background>
GuidedError draw_guided_focus(const GuidedView& view, const void* background, const Stripe& stripe)
{
    FocusSurface surface(view.field, view.camera);
    return render_guided<Policy, Pixel>(view.field, view.camera, surface, *static_cast<const Background*>(background),
                                        stripe);
}

template <class Policy, uint32_t Samples, class Pixel, class Background>
GuidedError draw_guided_proxy(const GuidedView& view, const void* background, const Stripe& stripe)
{
    ProxySurface<Samples> surface(view.frame, view.depths);
    return render_guided<Policy, Pixel>(view.field, view.camera, surface, *static_cast<const Background*>(background),
                                        stripe);
}

template <class Policy>
struct GuidedOverEach {
    RenderGuided focus = draw_guided_focus<Policy, PixelRgb565Swapped, OverColour>;
    RenderGuided proxy = draw_guided_proxy<Policy, 1, PixelRgb565, OverBlack>;
    RenderGuided samples = draw_guided_proxy<Policy, 4, PixelRgb888, OverStripe>;
};

template <class Texel, class Mean>
struct EveryStep {
    GuidedOverEach<GuidedPolicy<ThreeOrigins, LinearTaps, Texel, Mean, OcclusionUse::read>> best;
    GuidedOverEach<GuidedPolicy<ThreeOrigins, NearestTap, Texel, Mean, OcclusionUse::read>> nearest;
    GuidedOverEach<GuidedPolicy<OneOrigin, NearestTap, Texel, Mean, OcclusionUse::ignored>> one_origin;
};

struct EveryGuided {
    EveryStep<GuidedIndex4, MeanRgb565> index4_rgb565;
    EveryStep<GuidedIndex4, MeanPalette8> index4_palette8;
    EveryStep<GuidedIndex8, MeanRgb565> index8_rgb565;
    EveryStep<GuidedIndex4, NoMean> index4;
    EveryStep<GuidedIndex8, NoMean> index8;
    EveryStep<GuidedVq8, MeanPalette8> vq8_palette8;
    GuidedOverEach<GuidedPolicy<ThreeOrigins, LinearTaps, NoChart, MeanRgb565, OcclusionUse::ignored>> mean;
};

extern const EveryGuided kEveryGuidedPolicy;
const EveryGuided kEveryGuidedPolicy = {};

}  // namespace lumi::policies
