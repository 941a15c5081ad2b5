// SPDX-License-Identifier: MIT
// A baseline: draws an RGB565 sprite turned and scaled, nearest sample, pixels of value 0 and those outside left out.
// The field's bytes stand in for the sprite's.
#include "instance.h"
#include "lumi/bench/views.h"

namespace lumi::bench
{
namespace
{

// An arbitrary turn by 0.1 radian: the cost is the same for all.
constexpr int32_t kCosine_q16 = 65209;
constexpr int32_t kSine_q16 = 6543;
constexpr int32_t kMiddle = kSidePx / 2;

}  // namespace

RenderError draw(const Field& field, const Camera&, const Stripe& stripe, int32_t)
{
    const uint16_t* sprite = reinterpret_cast<const uint16_t*>(field.texels);
    for (int32_t row = 0; row < stripe.height_px; ++row) {
        const int32_t down = stripe.y_px + row - kMiddle;
        const int32_t right = stripe.x_px - kMiddle;
        int32_t u_q16 = right * kCosine_q16 - down * kSine_q16 + (kMiddle << 16);
        int32_t v_q16 = right * kSine_q16 + down * kCosine_q16 + (kMiddle << 16);
        uint16_t* pixel = reinterpret_cast<uint16_t*>(stripe.pixels + static_cast<uint32_t>(row) * stripe.stride_bytes);
        for (int32_t x = 0; x < stripe.width_px; ++x, u_q16 += kCosine_q16, v_q16 += kSine_q16) {
            const uint32_t u = static_cast<uint32_t>(u_q16 >> 16);
            const uint32_t v = static_cast<uint32_t>(v_q16 >> 16);
            if (u >= kSidePx || v >= kSidePx) continue;
            const uint16_t value = sprite[v * kSidePx + u];
            if (value != 0) pixel[x] = value;
        }
    }
    return RenderError::none;
}

}  // namespace lumi::bench
