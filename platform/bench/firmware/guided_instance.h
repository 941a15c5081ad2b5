// SPDX-License-Identifier: MIT
// The guided renderer under test: each bench program links exactly one.
#pragma once

#include "lumi/bench/views.h"
#include "lumi/guided/guided_field.h"
#include "lumi/pixel.h"
#include "lumi/proxy/proxy_frame.h"

namespace lumi::bench
{

inline constexpr uint32_t kGuidedStrideBytes = kSidePx * PixelRgb565::kBytes;

// Draws a frame of RGB565 pixels, the frame's proxy included; false for a field that the policy cannot read.
bool draw_guided(const GuidedField& field, const GuidedCamera& camera, uint8_t* pixels);

// Finds every pixel's surface and shades none.
void find_guided_surface(const GuidedField& field, const GuidedCamera& camera);

}  // namespace lumi::bench
