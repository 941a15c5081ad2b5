// SPDX-License-Identifier: MIT
// Draws one frame stripe by stripe, as firmware does that feeds a panel, and measures what it cost.
#pragma once

#include <cstdint>

#include "lumi/chord/render.h"

namespace lumi::firmware
{

inline constexpr int32_t kFrameWidth = 240;
inline constexpr int32_t kFrameHeight = 240;
inline constexpr int32_t kStripeHeight = 16;
static_assert(kFrameHeight % kStripeHeight == 0, "every stripe is full");

enum class Mode : uint8_t { nearest, linear, paper };

// Draws a stripe as RGB565 with the policies that a field and a mode ask for.
using DrawStripe = RenderError (*)(const Field&, const Camera&, const Stripe&);
DrawStripe choose_renderer(Mode mode, TexelFormat texels);

// Gets each finished stripe (RGB565, kFrameWidth × kStripeHeight, no padding); false stops the frame.
struct StripeSink {
    bool (*flush)(void* context, const uint8_t* pixels, uint32_t bytes);
    void* context;
};

struct FrameReport {
    uint32_t crc;
    uint32_t covered_px;    // pixels whose ray meets the sphere
    uint64_t instructions;  // in render() alone, to within a SysTick tick a stripe
    uint32_t stack_bytes;   // deepest stack of render() below its caller
    bool complete;          // drawn and flushed to the last stripe
};

FrameReport draw_measured_frame(const Field& field, const Camera& camera, DrawStripe draw, const StripeSink& sink);

}  // namespace lumi::firmware
