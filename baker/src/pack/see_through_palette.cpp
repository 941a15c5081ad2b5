// SPDX-License-Identifier: MIT
#include "pack/see_through_palette.h"

#include <algorithm>
#include <cmath>

#include "image/palette.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kSeeThroughPaletteSeed = 0x73736565;
constexpr size_t kMaxSeeThroughSamples = 32768;
constexpr float kBehindSpread = 30;                        // levels, of the light behind a texel around its mean
constexpr float kBackground = 40, kBackgroundSpread = 60;  // levels that displays have behind objects
constexpr float kBehindStep = 8;                           // levels, for slopes
constexpr float kWhiteLevel = 255;

float shown_level(float v)
{
    return std::clamp(v, 0.0f, kWhiteLevel);
}

Rgb radiance_of(const EncodedTone& tone, const LevelColour& levels)
{
    const Rgb r = tone.line_at(levels).inverse(levels);
    return {std::max(r.r, 0.0f), std::max(r.g, 0.0f), std::max(r.b, 0.0f)};
}

// Sums of a least-squares line, levels over levels behind.
struct LineSums {
    float weight = 0, behind = 0, behind2 = 0, level = 0, product = 0;

    // Weighted samples around a place on a line with this slope.
    void add(float w, float place, float spread, float value, float slope)
    {
        const float spread2 = spread * spread;
        weight += w;
        behind += w * place;
        behind2 += w * (place * place + spread2);
        level += w * value;
        product += w * (place * value + spread2 * slope);
    }
};

// The light that a texel adds, 0 .. 255 a channel, and the share that it lets pass, 0 .. 255, for all texels.
ColourPoint added_and_passed(const SeeThroughTexel& texel, const EncodedTone& tone, const LevelColour& levels)
{
    const float coverage = std::clamp(texel.coverage, 0.0f, 1.0f), clear = 1 - coverage;
    const LevelColour own = {shown_level(levels[0]), shown_level(levels[1]), shown_level(levels[2])};
    const Rgb own_light = radiance_of(tone, own) * coverage;
    const LevelColour behind = tone.encoded(texel.behind);
    const auto through = [&](float step) {
        const LevelColour at = {shown_level(behind[0] + step), shown_level(behind[1] + step),
                                shown_level(behind[2] + step)};
        return tone.encoded(own_light + radiance_of(tone, at) * clear);
    };
    const LevelColour here = through(0), above = through(kBehindStep), below = through(-kBehindStep);
    std::array<LineSums, 3> sums;
    float rise = 0, run = 0;
    for (size_t c = 0; c < 3; ++c) {
        const float place = shown_level(behind[c]),
                    width = shown_level(behind[c] + kBehindStep) - shown_level(behind[c] - kBehindStep);
        const float slope = width > 0 ? (above[c] - below[c]) / width : clear;
        sums[c].add(std::max(1 - texel.open, 1e-3f), place, kBehindSpread, here[c], slope);
        sums[c].add(std::max(texel.open, 1e-3f), kBackground, kBackgroundSpread,
                    coverage * own[c] + clear * kBackground, clear);
        const LineSums& s = sums[c];
        rise += s.product - s.behind * s.level / s.weight;
        run += s.behind2 - s.behind * s.behind / s.weight;
    }
    const float passed = std::clamp(rise / run, 0.0f, 1.0f);
    const auto added = [&](size_t c) {
        return shown_level((sums[c].level - passed * sums[c].behind) / sums[c].weight);
    };
    return {added(0), added(1), added(2), kWhiteLevel * passed};
}

uint8_t level_byte(float v)
{
    return static_cast<uint8_t>(std::lround(shown_level(v)));
}

}  // namespace

void put_see_through(const FitShape& shape, const EncodedTone& tone, const std::vector<LevelColour>& levels,
                     std::array<SeeThroughColour, detail::format::kPaletteEntries>& palette,
                     std::vector<uint8_t>& texels)
{
    std::vector<uint32_t> places;
    std::vector<ColourPoint> points;
    for (size_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        for (uint32_t t = r.begin; t < r.begin + r.size(); ++t) {
            places.push_back(t);
            points.push_back(added_and_passed(shape.see_through[t], tone, levels[t]));
        }
    }
    std::vector<ColourPoint> some;
    for (size_t k = 0; k < points.size(); k += points.size() / kMaxSeeThroughSamples + 1) some.push_back(points[k]);
    const std::vector<ColourPoint> centres = k_means(some, {}, palette.size(), kSeeThroughPaletteSeed);
    for (size_t k = 0; k < centres.size(); ++k) {
        const ColourPoint& c = centres[k];
        palette[k] = {{level_byte(c[0]), level_byte(c[1]), level_byte(c[2])},
                      {level_byte(c[3]), level_byte(c[3]), level_byte(c[3])}};
    }
    for (size_t k = 0; k < points.size(); ++k)
        texels[places[k]] = static_cast<uint8_t>(nearest_centre(centres, points[k]).index);
}

}  // namespace lumi::baker
