// SPDX-License-Identifier: MIT
// The guided renderer with the policies that the build names: LUMI_BENCH_ORIGINS, _TAPS, _CHART, _MEAN, _SAMPLES.
#include "guided_instance.h"

#include "lumi/guided/guided_render.h"
#include "lumi/guided/guided_vq.h"
#include "lumi/proxy/proxy_surface.h"

namespace lumi::bench
{
namespace
{

using Policy = GuidedPolicy<LUMI_BENCH_ORIGINS, LUMI_BENCH_TAPS, LUMI_BENCH_CHART, LUMI_BENCH_MEAN, OcclusionUse::read>;

constexpr uint32_t kSamples = LUMI_BENCH_SAMPLES;
constexpr uint32_t kBandLog2 = 4;
constexpr int32_t kStripeRows = 1 << kBandLog2;  // as firmware does that feeds a panel from a small buffer

ProxyVertex vertices[format::kMaxProxyVertices];
uint16_t links[format::kMaxProxyTriangles];
uint16_t bands[proxy_bands(kSidePx, kBandLog2)];
alignas(4) uint16_t depths[proxy_stripe_bytes(kSidePx, kStripeRows, kSamples) / sizeof(uint16_t)];

Stripe stripe_at(uint8_t* pixels, int32_t y)
{
    return {pixels + static_cast<uint32_t>(y) * kGuidedStrideBytes, 0, y, kSidePx, kStripeRows, kGuidedStrideBytes};
}

}  // namespace

bool draw_guided(const GuidedField& field, const GuidedCamera& camera, uint8_t* pixels)
{
    ProxyFrame frame;
    prepare_proxy(field.proxy, camera, kSamples, {vertices, links, bands, kBandLog2}, frame);
    ProxySurface<kSamples> surface(frame, depths);
    bool drawn = true;
    for (int32_t y = 0; y < kSidePx; y += kStripeRows) {
        const GuidedError error =
            render_guided<Policy, PixelRgb565>(field, camera.camera, surface, kBackground, stripe_at(pixels, y));
        drawn = drawn && error == GuidedError::none;
    }
    return drawn;
}

void find_guided_surface(const GuidedField& field, const GuidedCamera& camera)
{
    ProxyFrame frame;
    prepare_proxy(field.proxy, camera, kSamples, {vertices, links, bands, kBandLog2}, frame);
    ProxySurface<kSamples> surface(frame, depths);
    for (int32_t y = 0; y < kSidePx; ++y) {
        if (y % kStripeRows == 0) surface.begin_stripe({nullptr, 0, y, kSidePx, kStripeRows, 0});
        const RowSpan columns = surface.columns();
        surface.begin_row(y);
        for (int32_t x = columns.begin; x < columns.end; ++x) {
            SurfacePoint seen[kSamples];
            if (surface.at(x, seen) != 0)
                __asm volatile("" ::"r"(seen[0].x_q14), "r"(seen[0].y_q14), "r"(seen[0].z_q14));
        }
    }
}

}  // namespace lumi::bench
