// SPDX-License-Identifier: MIT
#include "pattern.h"

#include <algorithm>

namespace lumi::twin
{

namespace
{

constexpr uint32_t kPoints = 120;  // beyond the circumcircles of all triangles that are kept
constexpr uint32_t kWidest = 40;   // the longest Delaunay edges of these lead 34 indices on
constexpr double kRounding = 1e-9;

}  // namespace

Pattern::Plane Pattern::projected(const Place& place)
{
    const double radius = std::sqrt(std::fmax(0.0, place.height + 0.5)), angle = 2 * kPi * place.turns;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

double Pattern::area(const Plane& a, const Plane& b, const Plane& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Whether no other point lies in the circle through three, by its centre and radius.
bool Pattern::is_delaunay(const Corners& c) const
{
    const Plane &a = points_[c[0]], &b = points_[c[1]], &d = points_[c[2]];
    const Plane ab = {b.x - a.x, b.y - a.y}, ad = {d.x - a.x, d.y - a.y};
    const double doubled = 2 * area(a, b, d);
    const double ab2 = ab.x * ab.x + ab.y * ab.y, ad2 = ad.x * ad.x + ad.y * ad.y;
    const Plane out = {(ad.y * ab2 - ab.y * ad2) / doubled, (ab.x * ad2 - ad.x * ab2) / doubled};
    const double radius2 = out.x * out.x + out.y * out.y;
    return std::none_of(points_.begin(), points_.end(), [&](const Plane& p) {
        const double x = p.x - a.x - out.x, y = p.y - a.y - out.y;
        return x * x + y * y < radius2 - kRounding;
    });
}

Pattern::Pattern()
{
    for (uint32_t i = 0; i < kPoints; ++i) points_.push_back(projected({i / kGolden, static_cast<double>(i)}));
    for (uint32_t i = 0; i < kReach; ++i)
        for (uint32_t j = i + 1; j <= i + kWidest; ++j)
            for (uint32_t k = i + 1; k <= i + kWidest; ++k) {
                const Corners c = {i, j, k};
                if (area(points_[i], points_[j], points_[k]) > kRounding && is_delaunay(c)) triangles_.push_back(c);
            }
    for (const Corners& c : triangles_)
        for (const uint32_t a : c)
            for (const uint32_t b : c) edges_.insert({a, b});
}

Weights Pattern::weights(const Place& place) const
{
    const Plane p = projected(place);
    Weights best;
    double best_smallest = -1e9;
    for (const Corners& c : triangles_) {
        const Plane &a = points_[c[0]], &b = points_[c[1]], &d = points_[c[2]];
        const double whole = area(a, b, d);
        const double w[3] = {area(b, d, p) / whole, area(d, a, p) / whole, area(a, b, p) / whole};
        const double smallest = std::min({w[0], w[1], w[2]});
        if (smallest <= best_smallest) continue;
        best_smallest = smallest;
        best = {{c[0], w[0]}, {c[1], w[1]}, {c[2], w[2]}};
        if (smallest >= 0) break;
    }
    return best;
}

}  // namespace lumi::twin
