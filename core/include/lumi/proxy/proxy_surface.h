// SPDX-License-Identifier: MIT
// The surface of a guided field's proxy mesh, rasterized stripe by stripe: a Surface policy of guided_render.h.
//
//     ProxySurface<1> surface(frame, depths);  // frame: prepare_proxy(..., 1, ...); depths: proxy_stripe_bytes()
//     render_guided<...>(field, frame_camera.camera, surface, ...);
//
// A surface belongs to one renderer at a time; several may share a frame. Any rectangle of the image gives the same
// points as any other.
#pragma once

#include "lumi/detail/register_hints.h"
#include "lumi/guided/surface_point.h"
#include "lumi/proxy/proxy_frame.h"
#include "lumi/render.h"

namespace lumi
{

// Bytes of a stripe's depths: 2 a sample.
constexpr uint32_t proxy_stripe_bytes(int32_t width_px, int32_t rows_px, uint32_t samples)
{
    return static_cast<uint32_t>(width_px) * static_cast<uint32_t>(rows_px) * samples *
           static_cast<uint32_t>(sizeof(uint16_t));
}

// Clears the depths of a stripe and draws the triangles that reach it. Returns the columns outside which all of it is
// empty, at most the stripe's.
template <uint32_t Samples>
RowSpan rasterize_proxy(const ProxyFrame& frame, const Stripe& stripe, uint16_t* depths);

// Points of a row: X = end - back·ray + across·right, with `back` the depth before the far end of the range and
// `across` the place along the right axis.
struct ProxyRow {
    struct Component {
        int32_t end_q26, ray_q13;
    };
    Component component[3];
};
ProxyRow proxy_row(const ProxyRowRays& rays, int32_t y);

// A pixel's samples in rows, at [0] and [1] of an upper and a lower row; finds their distinct surfaces, each X at the
// mean of its samples' places.
uint32_t proxy_mixture(const ProxyFrame& frame, const ProxyRow& row, const uint16_t* upper, const uint16_t* lower,
                       int32_t x, SurfacePoint (&out)[4]);

// How far before the far end of the range a depth > 0 of the buffer lies, Q13.
int32_t exact_proxy_back(const ProxyDepths& depths, uint32_t depth);
LUMI_ALWAYS_INLINE int32_t proxy_back_q13(const ProxyDepths& depths, uint32_t depth)
{
    if (depth < depths.exact_below) return exact_proxy_back(depths, depth);
    const uint16_t* step = depths.back_q13 + (depth >> 8);
    const int32_t from = step[0];
    return from + (((step[1] - from) * static_cast<int32_t>(depth & 0xFF)) >> 8);
}

// The point of a pixel's centre line at a depth.
LUMI_ALWAYS_INLINE SurfacePoint proxy_point(const ProxyRays& rays, const ProxyRow& row, int32_t x, int32_t back_q13,
                                            uint32_t samples)
{
    const int32_t tangent_q13 = (rays.tangent_q26 + x * rays.tangent_step_q26) >> 13;
    const auto wrapped = [](int32_t v) { return static_cast<uint32_t>(v); };
    const uint32_t across_q26 = wrapped(rays.across_q26) + wrapped(x) * wrapped(rays.across_step_q26) -
                                wrapped(back_q13) * wrapped(tangent_q13);
    const uint32_t across_q13 = wrapped(static_cast<int32_t>(across_q26) >> 13);
    const auto component = [&](int k) {
        return static_cast<int32_t>(wrapped(row.component[k].end_q26) -
                                    wrapped(back_q13) * wrapped(row.component[k].ray_q13) +
                                    across_q13 * wrapped(rays.right_q13[k])) >>
               12;
    };
    return {component(0), component(1), component(2), samples};
}

template <uint32_t Samples>
class ProxySurface
{
public:
    static_assert(Samples == 1 || Samples == 4, "one sample a pixel, or four");
    static constexpr uint32_t kSamples = Samples;

    // `frame` was prepared with as many samples; `depths` takes proxy_stripe_bytes() of the largest stripe, at an
    // address divisible by 4.
    ProxySurface(const ProxyFrame& frame, uint16_t* depths) : frame_(frame), depths_(depths) {}

    void begin_stripe(const Stripe& stripe)
    {
        stripe_ = {stripe.x_px, stripe.y_px, stripe.width_px};
        y_ = INT32_MIN;
        columns_ = rasterize_proxy<Samples>(frame_, stripe, depths_);
    }

    // The columns of the stripe outside which every pixel is background.
    RowSpan columns() const { return columns_; }

    // The distinct surfaces of a pixel of the stripe whose ray meets the unit sphere; 0: background. Costs about 40
    // instructions where there is a surface, 8 elsewhere (Cortex-M4).
    LUMI_ALWAYS_INLINE uint32_t at(int32_t x, int32_t y, SurfacePoint (&out)[kSamples])
    {
        if (y != y_) begin_row(y);
        return at(x, out);
    }

    // The same for a row that was begun: four instructions less a pixel.
    LUMI_ALWAYS_INLINE uint32_t at(int32_t x, SurfacePoint (&out)[kSamples]) const
    {
        if constexpr (kSamples == 1) {
            const uint32_t depth = *depths_at(x);
            if (depth == kEmptyDepth) return 0;
            out[0] = proxy_point(frame_.rays, row_, x, proxy_back_q13(frame_.depths, depth), 1);
            return 1;
        } else {
            return mixture_at(x, out);
        }
    }

    // The first column of [x, end) of a row that was begun that is not background, or `end`.
    LUMI_ALWAYS_INLINE int32_t next(int32_t x, int32_t end) const
    {
        const uint16_t* upper = depths_at(x);
        for (; x < end; ++x, upper += kColumnBytes / sizeof(uint16_t)) {
            if constexpr (kSamples == 1) {
                if (*upper != kEmptyDepth) break;
            } else {
                if ((pair(upper) | pair(upper + 2 * stripe_.width)) != 0) break;
            }
        }
        return x;
    }

    __attribute__((noinline)) void begin_row(int32_t y)
    {
        y_ = y;
        row_ = proxy_row(frame_.row_rays, y);
        const uint32_t row = static_cast<uint32_t>(y - stripe_.y) * static_cast<uint32_t>(stripe_.width) * kSamples;
        column_0_ = reinterpret_cast<uintptr_t>(depths_ + row) - static_cast<uintptr_t>(stripe_.x) * kColumnBytes;
    }

private:
    struct Place {
        int32_t x, y, width;
    };
    static constexpr uintptr_t kColumnBytes = sizeof(uint16_t) * (kSamples > 1 ? 2 : 1);

    LUMI_ALWAYS_INLINE const uint16_t* depths_at(int32_t x) const
    {
        return reinterpret_cast<const uint16_t*>(column_0_ + static_cast<uintptr_t>(x) * kColumnBytes);
    }

    // Nearly every pixel is empty or lies on one surface: one comparison of its four samples tells.
    LUMI_ALWAYS_INLINE uint32_t mixture_at(int32_t x, SurfacePoint (&out)[kSamples]) const
    {
        const uint16_t* upper = depths_at(x);
        const uint16_t* lower = upper + 2 * stripe_.width;
        const uint32_t above = pair(upper), below = pair(lower);
        if ((above | below) == 0) return 0;
        const uint32_t a = above & 0xFFFF, b = above >> 16, c = below & 0xFFFF, d = below >> 16;
        const uint32_t near = frame_.depths.same_surface;
        const auto is_near = [&](uint32_t other) { return a - other + near <= 2 * near; };
        if (is_near(b) && is_near(c) && is_near(d)) {
            const uint32_t mean = (a + b + c + d + 2) >> 2;
            out[0] = proxy_point(frame_.rays, row_, x, proxy_back_q13(frame_.depths, mean), 4);
            return 1;
        }
        return proxy_mixture(frame_, row_, upper, lower, x, out);
    }

    // Two samples beside each other in one load; their order is the processor's and does not matter.
    LUMI_ALWAYS_INLINE static uint32_t pair(const uint16_t* at)
    {
        uint32_t both;
        __builtin_memcpy(&both, __builtin_assume_aligned(at, 4), sizeof both);
        return both;
    }

    const ProxyFrame& frame_;
    uintptr_t column_0_ = 0;  // where the row's depths would begin at the image's left side
    ProxyRow row_ = {};
    uint16_t* depths_;
    Place stripe_ = {0, 0, 0};
    RowSpan columns_ = {0, 0};
    int32_t y_ = INT32_MIN;
};

}  // namespace lumi
