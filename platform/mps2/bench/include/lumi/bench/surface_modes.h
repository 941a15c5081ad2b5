// SPDX-License-Identifier: MIT
// How the bench draws surface fields: the modes, their names in reports, and the stripes.
#pragma once

#include "lumi/bench/views.h"
#include "lumi/surface/render.h"

namespace lumi::bench
{

struct NamedSurfaceMode {
    const char* name;
    SurfaceMode mode;
};

inline constexpr NamedSurfaceMode kSurfaceModes[] = {
    {"one-sample", SurfaceMode::one_sample},
    {"antialiased", SurfaceMode::antialiased},
    {"2x2", SurfaceMode::two_by_two},
};

// Firmware that feeds a panel from a small buffer has the first height; the second takes half as much more memory.
inline constexpr int32_t kSurfaceStripeHeight = 16, kTallStripeHeight = 24;
inline constexpr uint32_t kSurfaceBandLog2 = surface_band_log2(kSurfaceStripeHeight);

// Memory that drawing a frame takes, the stripe's pixels left out.
constexpr uint32_t surface_ram_bytes(uint32_t vertices, uint32_t patches, SurfaceMode mode)
{
    return static_cast<uint32_t>(sizeof(SurfaceFrame)) +
           surface_frame_bytes(vertices, patches, kSidePx, kSurfaceBandLog2) +
           surface_stripe_bytes<PixelRgb565>(kSidePx, kSurfaceStripeHeight, mode);
}

}  // namespace lumi::bench
