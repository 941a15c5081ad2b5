// SPDX-License-Identifier: MIT
// A palette of 256 premultiplied colours with coverage, fitted to samples of a picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lumi/color.h"
#include "lumi/field_format.h"

namespace lumi::baker
{

// Entry 0 is fully transparent.
using Palette = std::array<detail::Rgba8, detail::format::kPaletteEntries>;

// k-means over (r, g, b, a) with weights that follow the eye; the same samples give the same palette. Samples without
// coverage need no entry and are skipped.
Palette fit_palette(const std::vector<detail::Rgba8>& samples);

// The entry that looks most alike, by the same measure. Cost: 256 distances.
uint8_t nearest_entry(const Palette& palette, const detail::Rgba8& colour);

}  // namespace lumi::baker
