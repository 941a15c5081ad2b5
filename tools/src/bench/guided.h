// SPDX-License-Identifier: MIT
// Guided fields on the bench: what the best picture and every step down from it costs.
#pragma once

#include "bench/measure.h"

namespace lumi::bench
{

// The fields that are drawn, the size of which the aims are about.
inline constexpr uint32_t kGuidedOrigins = 128, kGuidedChartSize = 96, kGuidedTriangles = 2500;
inline constexpr uint32_t kGuidedBlockChartSize = 134;  // as many bytes of texels

// Whether a mode draws guided fields.
bool is_guided(const std::string& mode);

// One row per core, view and guided mode of the matrix, for three fields of the bench's scene: "residual4" with
// mean colours, which every bake has by default, "residual_vq8" with blocks of 2×2 texels (linear alone), and "colour4"
// without a mean. Modes ending in -aa see four samples a pixel.
// Set-up is what finds the surface. Pictures are judged by the twin in double precision. Caches are not modelled: reads
// of lines and misses stay 0.
Rows measure_guided(const Settings& settings, const Announce& announce);

}  // namespace lumi::bench
