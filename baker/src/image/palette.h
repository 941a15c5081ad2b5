// SPDX-License-Identifier: MIT
// A palette of 256 premultiplied colours with coverage, fitted to samples of a picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lumi/color.h"
#include "lumi/field_format.h"
#include "math/sampler.h"

namespace lumi::baker
{

// Finds clusters of colours.

// Points have 6 numbers, or kMostPointNumbers; those that a palette does not need are 0.
using ColourPoint = std::array<float, 6>;
inline constexpr size_t kMostPointNumbers = 15;

struct NearestCentre {
    size_t index;
    float distance2;
};

// The lowest of equally near ones. Cost: a distance to each.
template <size_t N>
NearestCentre nearest_centre(const std::vector<std::array<float, N>>& centres, const std::array<float, N>& p);

// k-means++'s draw: an index with probability proportional to its squared distance; none where all are zero.
std::optional<size_t> drawn_by_distance(const std::vector<float>& distances2, Sampler& sampler);

// k-means with k-means++ seeding: centres of `points` that follow after `fixed`, which stay, `count` in all or fewer
// where that many different points are not there. The same points, in the same order, give the same centres.
template <size_t N>
std::vector<std::array<float, N>> k_means(const std::vector<std::array<float, N>>& points,
                                          std::vector<std::array<float, N>> fixed, size_t count, uint64_t seed);

// Entry 0 is fully transparent.
using Palette = std::array<detail::Rgba8, detail::format::kPaletteEntries>;

// k-means over (r, g, b, a) with weights that follow the eye; the same samples give the same palette. Samples without
// coverage need no entry and are skipped.
Palette fit_palette(const std::vector<detail::Rgba8>& samples);

// The entry that looks most alike, by the same measure. Cost: 256 distances.
uint8_t nearest_entry(const Palette& palette, const detail::Rgba8& colour);

}  // namespace lumi::baker
