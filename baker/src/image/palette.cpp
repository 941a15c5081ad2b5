// SPDX-License-Identifier: MIT
#include "image/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi::baker
{

namespace
{

template <size_t N>
using Point = std::array<float, N>;

constexpr int kIterations = 12;  // the error falls by less than 1 % an iteration from there on

template <size_t N>
float distance2(const Point<N>& a, const Point<N>& b)
{
    float sum = 0;
    for (size_t k = 0; k < N; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

// Each further centre is drawn with probability proportional to the squared distance from those already there.
template <size_t N>
void seed_centres(std::vector<Point<N>>& centres, const std::vector<Point<N>>& points, size_t count, uint64_t seed)
{
    std::vector<float> distances(points.size(), 1);
    const auto note = [&](const Point<N>& centre, bool first) {
        for (size_t k = 0; k < points.size(); ++k) {
            const float d = distance2(points[k], centre);
            distances[k] = first ? d : std::min(distances[k], d);
        }
    };
    for (size_t k = 0; k < centres.size(); ++k) note(centres[k], k == 0);
    Sampler sampler(seed, 0, 0);
    while (centres.size() < count) {
        const std::optional<size_t> chosen = drawn_by_distance(distances, sampler);
        if (!chosen) break;  // every colour has a centre of its own
        centres.push_back(points[*chosen]);
        note(centres.back(), centres.size() == 1);
    }
}

// Moves each centre from the `fixed`-th on to the mean of the points nearest to it.
template <size_t N>
void refine(std::vector<Point<N>>& centres, size_t fixed, const std::vector<Point<N>>& points)
{
    std::vector<std::array<double, N + 1>> sums(centres.size());
    for (const Point<N>& p : points) {
        std::array<double, N + 1>& sum = sums[nearest_centre(centres, p).index];
        for (size_t k = 0; k < N; ++k) sum[k] += static_cast<double>(p[k]);
        sum[N] += 1;
    }
    for (size_t c = fixed; c < centres.size(); ++c)
        for (size_t k = 0; k < N && sums[c][N] > 0; ++k) centres[c][k] = static_cast<float>(sums[c][k] / sums[c][N]);
}

}  // namespace

std::optional<size_t> drawn_by_distance(const std::vector<float>& distances2, Sampler& sampler)
{
    double total = 0;
    for (const float d : distances2) total += static_cast<double>(d);
    if (!(total > 0)) return std::nullopt;
    double left = static_cast<double>(sampler.next_1d()) * total;
    size_t chosen = 0;
    for (size_t k = 0; k < distances2.size() && left >= 0; ++k) {
        chosen = distances2[k] > 0 ? k : chosen;
        left -= static_cast<double>(distances2[k]);
    }
    return chosen;
}

template <size_t N>
NearestCentre nearest_centre(const std::vector<Point<N>>& centres, const Point<N>& p)
{
    NearestCentre best = {0, std::numeric_limits<float>::infinity()};
    for (size_t k = 0; k < centres.size(); ++k) {
        const float d = distance2(centres[k], p);
        best = d < best.distance2 ? NearestCentre{k, d} : best;
    }
    return best;
}

template <size_t N>
std::vector<Point<N>> k_means(const std::vector<Point<N>>& points, std::vector<Point<N>> fixed, size_t count,
                              uint64_t seed)
{
    std::vector<Point<N>> centres = std::move(fixed);
    const size_t fixed_count = centres.size();
    seed_centres(centres, points, count, seed);
    for (int k = 0; k < kIterations; ++k) refine(centres, fixed_count, points);
    return centres;
}

template NearestCentre nearest_centre(const std::vector<Point<kMostPointNumbers>>&, const Point<kMostPointNumbers>&);
template NearestCentre nearest_centre(const std::vector<ColourPoint>&, const ColourPoint&);
template std::vector<Point<kMostPointNumbers>> k_means(const std::vector<Point<kMostPointNumbers>>&,
                                                       std::vector<Point<kMostPointNumbers>>, size_t, uint64_t);
template std::vector<ColourPoint> k_means(const std::vector<ColourPoint>&, std::vector<ColourPoint>, size_t, uint64_t);

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
