// SPDX-License-Identifier: MIT
// From the levels of texels to bytes and the palettes that these name.
#pragma once

#include "fit/encoded_tone.h"
#include "fit/fit_shape.h"
#include "lumi/color.h"
#include "lumi/surface/format.h"

namespace lumi::baker
{

using PaletteColours = std::array<Rgb8, detail::format::kPaletteEntries>;

struct PalettedTexels {
    std::vector<PaletteColours> palettes, added;  // by state; `added` of see-through texels
    PaletteColours passed{};
    std::vector<uint8_t> texels;
};

// Each texel shows this in a state of the light; borrowed. All its light is divided by `scale`.
struct StateLevels {
    const std::vector<LevelColour>& texels;
    float scale = 1;
    Rgb factor = grey(1);  // the scale, times the weight until another is chosen
};
using LevelsOfStates = std::vector<StateLevels>;

// Levels are compared as they are seen at full weight. What a lamp does not reach is far from all else, so that it
// stays black. Of one state alone: the level itself.
float compared_level(const LevelsOfStates& states, size_t state, float level);

// `all`: what texels show in all states together. `kept`: the last entries of see-through texels that stay free.
PalettedTexels paletted(const FitShape& shape, const EncodedTone& tone, const LevelsOfStates& levels,
                        const std::vector<LevelColour>& all, size_t kept);

}  // namespace lumi::baker
