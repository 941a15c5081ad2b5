// SPDX-License-Identifier: MIT
// Every combination of reconstruction × texel × pixel × background that core offers, and all of core's functions that
// firmware calls, for tests that read symbols and stack sizes. Never run.
#include "lumi/render.h"
#include "lumi/span.h"

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
    EveryTexel<BySpans<Linear>> linear_spans;
};

extern const EveryReconstruction kEveryPolicy;
const EveryReconstruction kEveryPolicy = {};

}  // namespace lumi::policies
