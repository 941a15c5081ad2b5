// SPDX-License-Identifier: MIT
// A palette for the texels of a surface field.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fit/encoded_tone.h"
#include "lumi/color.h"
#include "lumi/field_format.h"

namespace lumi::baker
{

struct PalettedTexels {
    std::array<Rgb8, format::kPaletteEntries> palette{};
    std::vector<uint8_t> texels;
};

// The least squared error, of colours as they can be shown.
PalettedTexels paletted(const std::vector<LevelColour>& texels);

}  // namespace lumi::baker
