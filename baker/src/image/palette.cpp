// SPDX-License-Identifier: MIT
#include "image/palette.h"

#include <algorithm>
#include <cmath>

#include "image/k_means.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPaletteSeed = 0x70616C;

// Square roots of the shares that the channels have in seen differences of encoded values; coverage moves all of them.
constexpr float kWeights[4] = {0.55f, 0.77f, 0.33f, 0.8f};

ColourPoint to_point(const detail::Rgba8& c)
{
    return {kWeights[0] * c.r, kWeights[1] * c.g, kWeights[2] * c.b, kWeights[3] * c.a};
}

detail::Rgba8 to_colour(const ColourPoint& p)
{
    const auto channel = [&](size_t k) {
        return static_cast<uint8_t>(std::clamp(std::lround(p[k] / kWeights[k]), 0L, 255L));
    };
    const uint8_t a = channel(3);
    return {std::min(channel(0), a), std::min(channel(1), a), std::min(channel(2), a), a};
}

}  // namespace

Palette fit_palette(const std::vector<detail::Rgba8>& samples)
{
    std::vector<ColourPoint> points;
    for (const detail::Rgba8& c : samples)
        if (c.a != 0) points.push_back(to_point(c));
    Palette palette{};
    if (points.empty()) return palette;
    const std::vector<ColourPoint> centres =
        k_means(points, {ColourPoint{}}, detail::format::kPaletteEntries, kPaletteSeed);
    for (size_t k = 1; k < centres.size(); ++k) palette[k] = to_colour(centres[k]);
    return palette;
}

uint8_t nearest_entry(const Palette& palette, const detail::Rgba8& colour)
{
    std::vector<ColourPoint> centres(palette.size());
    std::transform(palette.begin(), palette.end(), centres.begin(), to_point);
    return static_cast<uint8_t>(nearest_centre(centres, to_point(colour)).index);
}

}  // namespace lumi::baker
