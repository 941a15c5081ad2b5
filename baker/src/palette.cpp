// SPDX-License-Identifier: MIT
// k-means++ seeding: Arthur & Vassilvitskii, "k-means++: The Advantages of Careful Seeding", SODA 2007.
#include "palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sampler.h"

namespace lumi::baker
{
namespace
{

constexpr int kIterations = 12;  // the error falls by less than 1 % an iteration from there on
constexpr uint64_t kSeed = 0x70616C;

// Square roots of the shares that the channels have in seen differences of encoded values; coverage moves all of them.
constexpr float kWeights[4] = {0.55f, 0.77f, 0.33f, 0.8f};

using Point = std::array<float, 4>;

Point to_point(const Rgba8& c)
{
    return {kWeights[0] * c.r, kWeights[1] * c.g, kWeights[2] * c.b, kWeights[3] * c.a};
}

float distance2(const Point& a, const Point& b)
{
    float sum = 0;
    for (size_t k = 0; k < 4; ++k) {
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return sum;
}

Rgba8 to_colour(const Point& p)
{
    const auto channel = [&](size_t k) {
        return static_cast<uint8_t>(std::clamp(std::lround(p[k] / kWeights[k]), 0L, 255L));
    };
    const uint8_t a = channel(3);
    return {std::min(channel(0), a), std::min(channel(1), a), std::min(channel(2), a), a};
}

struct Nearest {
    size_t index;
    float distance2;
};

Nearest nearest_of(const std::vector<Point>& centres, const Point& p)
{
    Nearest best = {0, std::numeric_limits<float>::infinity()};
    for (size_t k = 0; k < centres.size(); ++k) {
        const float d = distance2(centres[k], p);
        best = d < best.distance2 ? Nearest{k, d} : best;
    }
    return best;
}

// Centre 0 is the transparent one; each further one is drawn with probability proportional to the squared distance from
// those already there.
std::vector<Point> seeded(const std::vector<Point>& points)
{
    std::vector<Point> centres = {Point{}};
    std::vector<float> distances(points.size());
    std::transform(points.begin(), points.end(), distances.begin(),
                   [&](const Point& p) { return distance2(p, centres[0]); });
    Sampler sampler(kSeed, 0, 0);
    while (centres.size() < format::kPaletteEntries) {
        double total = 0;
        for (const float d : distances) {
            total += static_cast<double>(d);
        }
        if (!(total > 0)) {
            break;  // every colour has an entry of its own
        }
        double left = static_cast<double>(sampler.next_1d()) * total;
        size_t chosen = 0;
        for (size_t k = 0; k < points.size() && left >= 0; ++k) {
            chosen = distances[k] > 0 ? k : chosen;
            left -= static_cast<double>(distances[k]);
        }
        centres.push_back(points[chosen]);
        for (size_t k = 0; k < points.size(); ++k) {
            distances[k] = std::min(distances[k], distance2(points[k], centres.back()));
        }
    }
    return centres;
}

// Moves each centre but the first to the mean of the points nearest to it.
void refine(std::vector<Point>& centres, const std::vector<Point>& points)
{
    std::vector<std::array<double, 5>> sums(centres.size());
    for (const Point& p : points) {
        std::array<double, 5>& sum = sums[nearest_of(centres, p).index];
        for (size_t k = 0; k < 4; ++k) {
            sum[k] += static_cast<double>(p[k]);
        }
        sum[4] += 1;
    }
    for (size_t c = 1; c < centres.size(); ++c) {
        for (size_t k = 0; k < 4 && sums[c][4] > 0; ++k) {
            centres[c][k] = static_cast<float>(sums[c][k] / sums[c][4]);
        }
    }
}

}  // namespace

Palette fit_palette(const std::vector<Rgba8>& samples)
{
    std::vector<Point> points;
    for (const Rgba8& c : samples) {
        if (c.a != 0) {
            points.push_back(to_point(c));
        }
    }
    Palette palette{};
    if (points.empty()) {
        return palette;
    }
    std::vector<Point> centres = seeded(points);
    for (int k = 0; k < kIterations; ++k) {
        refine(centres, points);
    }
    for (size_t k = 1; k < centres.size(); ++k) {
        palette[k] = to_colour(centres[k]);
    }
    return palette;
}

uint8_t nearest_entry(const Palette& palette, const Rgba8& colour)
{
    const Point p = to_point(colour);
    size_t best = 0;
    float best_distance = std::numeric_limits<float>::infinity();
    for (size_t k = 0; k < palette.size(); ++k) {
        const float d = distance2(to_point(palette[k]), p);
        if (d < best_distance) {
            best_distance = d;
            best = k;
        }
    }
    return static_cast<uint8_t>(best);
}

}  // namespace lumi::baker
