// SPDX-License-Identifier: MIT
// Packs the light that see-through texels add and let pass into the format's bits.
//
// A path through glass adds light; a display blends encoded levels. So for each texel the line is chosen that shows the
// right levels for about the light behind it, and over the background what a blend with its coverage shows.
#pragma once

#include "fit/fit_model.h"
#include "pack/surface_writer.h"

namespace lumi::baker
{

// Sets the palette, and those of `texels` that are see-through. `levels`: what the surface itself shows, by texel.
void put_see_through(const FitShape& shape, const EncodedTone& tone, const std::vector<LevelColour>& levels,
                     std::array<SeeThroughColour, detail::format::kPaletteEntries>& palette,
                     std::vector<uint8_t>& texels);

}  // namespace lumi::baker
