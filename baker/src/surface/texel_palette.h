// SPDX-License-Identifier: MIT
// A palette for the texels of a surface field.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lumi/color.h"
#include "lumi/field_format.h"

namespace lumi::baker
{

using LevelColour = std::array<float, 3>;  // encoded, 0 .. 255; of a fit also a little beyond

struct PalettedTexels {
    std::array<Rgb8, format::kPaletteEntries> palette{};
    std::vector<uint8_t> texels;
};

// The least squared error, of colours as they can be shown.
PalettedTexels paletted(const std::vector<LevelColour>& texels);

}  // namespace lumi::baker
