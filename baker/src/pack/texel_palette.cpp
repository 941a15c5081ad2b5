// SPDX-License-Identifier: MIT
#include "pack/texel_palette.h"

#include <algorithm>
#include <cmath>

#include "image/palette.h"
#include "scene/light_states.h"

namespace lumi::baker
{
namespace
{

// Packs the light that see-through texels add and let pass into the format's bits.
//
// A path through glass adds light; a display blends encoded levels. So for each texel the line is chosen that shows the
// right levels for about the light behind it, and over the background what a blend with its coverage shows.

constexpr uint64_t kSeeThroughPaletteSeed = 0x73736565;
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

// The light that a texel adds, and the share that it lets pass, both 0 .. 255 a channel.
std::array<float, 6> added_and_passed(const SeeThroughTexel& texel, const EncodedTone& tone, const LevelColour& levels)
{
    const float coverage = std::clamp(texel.coverage, 0.0f, 1.0f), clear = 1 - coverage;
    const auto [least, most] = std::minmax({texel.through.r, texel.through.g, texel.through.b});
    const float hue = 1 - least / std::max(most, 1e-6f);
    const auto background = [&](float level) {  // by coverage as a display blends, or coloured as what stands there
        const LevelColour lit = tone.encoded(radiance_of(tone, {level, level, level}) * texel.through);
        const auto channel = [&](size_t c) { return (1 - hue) * clear * level + hue * lit[c]; };
        return LevelColour{channel(0), channel(1), channel(2)};
    };
    const LevelColour back = background(kBackground), brighter = background(kBackground + kBehindStep);
    const float shares[3] = {texel.through.r, texel.through.g, texel.through.b};
    const LevelColour own = {shown_level(levels[0]), shown_level(levels[1]), shown_level(levels[2])};
    const Rgb own_light = radiance_of(tone, own) * coverage;
    const LevelColour behind = tone.encoded(texel.behind);
    const auto through = [&](float step) {
        const LevelColour at = {shown_level(behind[0] + step), shown_level(behind[1] + step),
                                shown_level(behind[2] + step)};
        return tone.encoded(own_light + radiance_of(tone, at) * texel.through);
    };
    const LevelColour here = through(0), above = through(kBehindStep), below = through(-kBehindStep);
    std::array<float, 6> result{};
    for (size_t c = 0; c < 3; ++c) {
        const float place = shown_level(behind[c]),
                    width = shown_level(behind[c] + kBehindStep) - shown_level(behind[c] - kBehindStep);
        const float slope = width > 0 ? (above[c] - below[c]) / width : shares[c];
        LineSums s;
        s.add(std::max(1 - texel.open, 1e-3f), place, kBehindSpread, here[c], slope);
        s.add(std::max(texel.open, 1e-3f), kBackground, kBackgroundSpread, coverage * own[c] + back[c],
              (brighter[c] - back[c]) / kBehindStep);
        const float rise = s.product - s.behind * s.level / s.weight, run = s.behind2 - s.behind * s.behind / s.weight;
        const float passed = std::clamp(rise / run, 0.0f, 1.0f);
        result[c] = shown_level((s.level - passed * s.behind) / s.weight);
        result[c + 3] = kWhiteLevel * passed;
    }
    return result;
}

uint8_t level_byte(float v)
{
    return static_cast<uint8_t>(std::lround(shown_level(v)));
}

template <size_t N>
Rgb8 colour_at(const std::array<float, N>& point, size_t at)
{
    return {level_byte(point[at]), level_byte(point[at + 1]), level_byte(point[at + 2])};
}

// By texel: whether its patch is see-through.
std::vector<bool> see_through_texels(const FitShape& shape)
{
    std::vector<bool> is_see_through(shape.layout.texels);
    for (uint32_t p = shape.mesh.opaque_patches(); p < shape.mesh.patches.size(); ++p) {
        const PatchRectangle& r = shape.layout.rectangles[p];
        std::fill_n(is_see_through.begin() + r.begin, r.size(), true);
    }
    return is_see_through;
}

std::vector<uint32_t> texels_of(const FitShape& shape, bool see_through)
{
    const std::vector<bool> is_see_through = see_through_texels(shape);
    std::vector<uint32_t> texels;
    for (uint32_t t = 0; t < is_see_through.size(); ++t)
        if (is_see_through[t] == see_through) texels.push_back(t);
    return texels;
}

constexpr uint64_t kTexelPaletteSeed = 0x73706C;
constexpr size_t kMaxSamples = 32768;  // more change the palette's error by less than a hundredth

constexpr float kBlackApart = 8;  // levels

// The inverse of compared_level.
float own_level(const LevelsOfStates& states, size_t state, float compared)
{
    return states.size() == 1 ? compared : std::max(compared - kBlackApart, 0.0f) / times_seen(states[state].scale);
}

// Returns what the texel shows in each state.
template <size_t N>
std::array<float, N> point_of(const LevelsOfStates& levels, size_t texel)
{
    std::array<float, N> point{};
    for (size_t k = 0; k < levels.size(); ++k)
        for (size_t c = 0; c < 3; ++c)
            point[3 * k + c] = compared_level(levels, k, shown_level(levels[k].texels[texel][c]));
    return point;
}

// The least squared error of opaque texels, of colours as they can be shown.
template <size_t N>
void put_opaque(const FitShape& shape, const LevelsOfStates& levels, PalettedTexels& result)
{
    const std::vector<uint32_t> opaque = texels_of(shape, false);
    std::vector<std::array<float, N>> some;
    for (size_t k = 0; k < opaque.size(); k += opaque.size() / kMaxSamples + 1)
        some.push_back(point_of<N>(levels, opaque[k]));
    std::vector<std::array<float, N>> centres = k_means(some, {}, detail::format::kPaletteEntries, kTexelPaletteSeed);
    for (size_t k = 0; k < centres.size(); ++k) {
        std::array<float, N> own{};
        for (size_t n = 0; n < 3 * levels.size(); ++n) {
            own[n] = std::round(own_level(levels, n / 3, centres[k][n]));
            centres[k][n] = compared_level(levels, n / 3, own[n]);
        }
        for (size_t s = 0; s < levels.size(); ++s) result.palettes[s][k] = colour_at(own, 3 * s);
    }
    for (size_t t = 0; t < levels[0].texels.size(); ++t)
        result.texels.push_back(static_cast<uint8_t>(nearest_centre(centres, point_of<N>(levels, t)).index));
}

// Puts the light that is added in each state, then the share that passes, which is that of `all`.
template <size_t N>
void put_see_through(const FitShape& shape, const EncodedTone& tone, const LevelsOfStates& levels,
                     const std::vector<LevelColour>& all, size_t kept, PalettedTexels& result)
{
    const std::vector<uint32_t> places = texels_of(shape, true);
    const size_t passed = 3 * levels.size();
    std::vector<std::array<float, N>> points, some;
    for (const uint32_t t : places) {
        std::array<float, N> point{};
        for (size_t k = 0; k < levels.size(); ++k) {
            const auto added = added_and_passed(shape.see_through[t], tone, levels[k].texels[t]);
            std::copy_n(added.begin(), 3, point.begin() + static_cast<ptrdiff_t>(3 * k));
        }
        const auto mixed = added_and_passed(shape.see_through[t], tone, all[t]);
        std::copy_n(mixed.begin() + 3, 3, point.begin() + static_cast<ptrdiff_t>(passed));
        points.push_back(point);
    }
    for (size_t k = 0; k < points.size(); k += points.size() / kMaxSamples + 1) some.push_back(points[k]);
    const std::vector<std::array<float, N>> centres =
        k_means(some, {}, detail::format::kPaletteEntries - kept, kSeeThroughPaletteSeed);
    for (size_t k = 0; k < centres.size(); ++k) {
        for (size_t s = 0; s < levels.size(); ++s) result.added[s][k] = colour_at(centres[k], 3 * s);
        result.passed[k] = colour_at(centres[k], passed);
    }
    for (size_t k = 0; k < points.size(); ++k)
        result.texels[places[k]] = static_cast<uint8_t>(nearest_centre(centres, points[k]).index);
}

template <size_t N>
PalettedTexels paletted_in(const FitShape& shape, const EncodedTone& tone, const LevelsOfStates& levels,
                           const std::vector<LevelColour>& all, size_t kept)
{
    PalettedTexels result;
    result.palettes.resize(levels.size());
    result.added.resize(levels.size());
    put_opaque<N>(shape, levels, result);
    if (shape.mesh.see_through_patches != 0) put_see_through<N>(shape, tone, levels, all, kept, result);
    return result;
}

}  // namespace

float compared_level(const LevelsOfStates& states, size_t state, float level)
{
    constexpr float kBlack = 0.5f;  // levels below it are shown as 0
    if (states.size() == 1) return level;
    return level < kBlack ? 0 : kBlackApart + times_seen(states[state].scale) * level;
}

PalettedTexels paletted(const FitShape& shape, const EncodedTone& tone, const LevelsOfStates& levels,
                        const std::vector<LevelColour>& all, size_t kept)
{
    constexpr size_t kOneState = 6;
    static_assert(kMostPointNumbers >= 3 * (detail::format::kMaxStates + 1), "what is added, and what passes");
    return levels.size() == 1 ? paletted_in<kOneState>(shape, tone, levels, all, kept)
                              : paletted_in<kMostPointNumbers>(shape, tone, levels, all, kept);
}

}  // namespace lumi::baker
