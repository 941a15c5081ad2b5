// SPDX-License-Identifier: MIT
#include "lumi/twin/weights.h"

#include <algorithm>

#include "pattern.h"

namespace lumi::twin
{
namespace
{

constexpr uint32_t kMinHull = 4, kMinPattern = 64;  // see lumi::triangle
constexpr int kPolarZone = 6;

const Pattern& pattern()
{
    static const Pattern made;
    return made;
}

// Whether a cell is cut along the sum of its steps.
bool is_obtuse(uint32_t n, int k, double corner)
{
    const double to_middle = (fibonacci(k) + fibonacci(k + 1)) / 2;
    const double middle = std::min(corner + to_middle, n - 1 - corner - to_middle);
    const double lowest = middle - to_middle;  // this cell has it, or its mirror image
    if (k != kPolarZone) return steepness(middle, n) >= std::pow(kGolden, 2 * k + 1);
    const auto first = static_cast<int32_t>(lowest);
    return first >= 0 &&
           pattern().has_edge(static_cast<uint32_t>(first), static_cast<uint32_t>(first + std::lround(2 * to_middle)));
}

Weights cell_weights(const Place& place, uint32_t n)
{
    const int k = static_cast<int>(std::floor(zone_of(place.height, n)));
    const auto [u, v] = coordinates(place, k);
    const double fu = u - std::floor(u);
    const double fv = v - std::floor(v);
    const double corner = fibonacci(k) * std::floor(u) + fibonacci(k + 1) * std::floor(v);
    const auto index = [](double i) { return static_cast<uint32_t>(std::lround(i)); };
    const uint32_t near = index(corner);
    const uint32_t first = index(corner + fibonacci(k));
    const uint32_t second = index(corner + fibonacci(k + 1));
    const uint32_t far = index(corner + fibonacci(k) + fibonacci(k + 1));
    if (is_obtuse(n, k, corner))
        return {{near, 1 - std::max(fu, fv)}, {fu > fv ? first : second, std::fabs(fu - fv)}, {far, std::min(fu, fv)}};
    if (fu + fv < 1) return {{near, 1 - fu - fv}, {first, fu}, {second, fv}};
    return {{far, fu + fv - 1}, {first, 1 - fv}, {second, 1 - fu}};
}

// Where the corners' longitudes and heights, weighted, put a place.
Place moved(const Place& place, const Weights& weights)
{
    Place mean = place;
    for (const auto& [i, w] : weights) {
        const double turn = i / kGolden - place.turns;
        mean.turns += w * (turn - std::round(turn));
        mean.height += w * (i - place.height);
    }
    return mean;
}

Weights northern_weights(const Place& place, uint32_t n, const Transition& transition)
{
    if (place.height >= transition.end) return cell_weights(place, n);
    const Weights in_plane = pattern().weights(place);
    if (place.height < transition.begin) return in_plane;
    const double share = (transition.end - place.height) / (transition.end - transition.begin);
    const Place all_the_way = moved(place, in_plane);
    return cell_weights({place.turns + share * (all_the_way.turns - place.turns),
                         place.height + share * (all_the_way.height - place.height)},
                        n);
}

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Finds the outermost triangle of points that the ray from the centre through q passes: it belongs to the convex hull.
Weights hull_weights(const std::vector<Vec3>& all, const Vec3& q)
{
    const auto n = static_cast<uint32_t>(all.size());
    std::vector<double> areas;
    for (const Vec3& a : all)
        for (const Vec3& b : all) areas.push_back(dot(q, cross(a, b)));
    const auto area = [&](uint32_t i, uint32_t j) { return areas[i * n + j]; };
    Weights best;
    double farthest = 0;
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t j = i + 1; j < n; ++j)
            for (uint32_t k = i + 1; k < n; ++k) {
                const double w[3] = {area(j, k), area(k, i), area(i, j)}, sum = w[0] + w[1] + w[2];
                if (w[0] < 0 || w[1] < 0 || w[2] < 0 || sum <= 0) continue;
                const double distance = dot(q, (1 / sum) * (w[0] * all[i] + w[1] * all[j] + w[2] * all[k]));
                if (distance <= farthest) continue;
                farthest = distance;
                best = {{i, w[0] / sum}, {j, w[1] / sum}, {k, w[2] / sum}};
            }
    return best;
}

Weights height_weights(double height, uint32_t n)
{
    const double held = std::clamp(height, 0.0, n - 1.0);
    const auto above = static_cast<uint32_t>(held);
    return {{above, 1 - (held - above)}, {std::min(above + 1, n - 1), held - above}};
}

}  // namespace

Weights linear_weights(const std::vector<Vec3>& all, const Vec3& q, const Transition& transition)
{
    const auto n = static_cast<uint32_t>(all.size());
    if (n < kMinHull) return height_weights(place_of(q, n).height, n);
    if (n < kMinPattern) return hull_weights(all, q);
    Weights weights = northern_weights(place_of(northern(q, n), n), n, transition);
    for (auto& [i, w] : weights) i = q.z < 0 ? n - 1 - i : i;
    return weights;
}

}  // namespace lumi::twin
