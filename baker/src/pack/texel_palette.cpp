// SPDX-License-Identifier: MIT
#include "pack/texel_palette.h"

#include <algorithm>
#include <cmath>

#include "image/k_means.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kTexelPaletteSeed = 0x73706C;
constexpr size_t kMaxSamples = 32768;  // more change the palette's error by less than a hundredth

ColourPoint point_of(const LevelColour& c)
{
    const auto shown = [](float v) { return std::clamp(v, 0.0f, 255.0f); };
    return {shown(c[0]), shown(c[1]), shown(c[2]), 0};
}

std::vector<ColourPoint> centres_for(const std::vector<LevelColour>& texels)
{
    std::vector<ColourPoint> points;
    const size_t stride = texels.size() / kMaxSamples + 1;
    for (size_t k = 0; k < texels.size(); k += stride) points.push_back(point_of(texels[k]));
    std::vector<ColourPoint> centres = k_means(points, {}, format::kPaletteEntries, kTexelPaletteSeed);
    for (ColourPoint& c : centres)
        for (float& v : c) v = std::round(v);
    return centres;
}

}  // namespace

PalettedTexels paletted(const std::vector<LevelColour>& texels)
{
    const std::vector<ColourPoint> centres = centres_for(texels);
    PalettedTexels result;
    for (size_t k = 0; k < centres.size(); ++k) {
        const ColourPoint& c = centres[k];
        result.palette[k] = {static_cast<uint8_t>(c[0]), static_cast<uint8_t>(c[1]), static_cast<uint8_t>(c[2])};
    }
    for (const LevelColour& t : texels)
        result.texels.push_back(static_cast<uint8_t>(nearest_centre(centres, point_of(t)).index));
    return result;
}

}  // namespace lumi::baker
