// SPDX-License-Identifier: MIT
// Every combination of reconstruction × texel × pixel × background that core offers, and all of core's functions that
// firmware calls, for tests that read symbols and stack sizes. Never run.
#include "lumi/render.h"

namespace lumi::policies
{

using Render = RenderError (*)(const Field&, const Camera&, const void* background, const Stripe&);

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError draw(const Field& field, const Camera& camera, const void* background, const Stripe& stripe)
{
    return render<Reconstruction, Texel, Pixel>(field, camera, *static_cast<const Background*>(background), stripe);
}

template <class Reconstruction, class Texel, class Pixel>
struct OverBoth {
    Render colour = draw<Reconstruction, Texel, Pixel, OverColour>;
    Render stripe = draw<Reconstruction, Texel, Pixel, OverStripe>;
};

template <class Reconstruction, class Texel>
struct EveryPixel {
    OverBoth<Reconstruction, Texel, PixelRgb565> rgb565;
    OverBoth<Reconstruction, Texel, PixelRgb565Swapped> rgb565_swapped;
    OverBoth<Reconstruction, Texel, PixelRgb888> rgb888;
    OverBoth<Reconstruction, Texel, PixelGrey8> grey8;
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
};

extern const EveryReconstruction kEveryPolicy;
const EveryReconstruction kEveryPolicy = {};

}  // namespace lumi::policies
