// SPDX-License-Identifier: MIT
// A baseline: copies an RGB565 sprite of the picture's size, pixels of value 0 left out. The field's bytes stand in
// for the sprite's: the cost does not depend on them but for the share of zeros.
#include "instance.h"
#include "lumi/bench/views.h"

namespace lumi::bench
{

RenderError draw(const Field& field, const Camera&, const Stripe& stripe, int32_t)
{
    for (int32_t row = 0; row < stripe.height_px; ++row) {
        const uint32_t first = static_cast<uint32_t>((stripe.y_px + row) * kSidePx + stripe.x_px);
        const uint16_t* sprite = reinterpret_cast<const uint16_t*>(field.texels) + first;
        uint16_t* pixel = reinterpret_cast<uint16_t*>(stripe.pixels + static_cast<uint32_t>(row) * stripe.stride_bytes);
        for (int32_t x = 0; x < stripe.width_px; ++x)
            if (sprite[x] != 0) pixel[x] = sprite[x];
    }
    return RenderError::none;
}

}  // namespace lumi::bench
