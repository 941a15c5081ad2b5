// SPDX-License-Identifier: MIT
#include "lumi/twin/weights.h"

#include <algorithm>

#include "lattice/polar.h"

namespace lumi::twin
{
namespace
{

constexpr uint32_t kSmallSize = 64;  // below it there is no lattice to speak of, see lumi::triangle

struct Plane {
    double x, y;
};

Weights polar_weights(const Vec3& q, uint32_t n)
{
    const auto at = [](double t, double turns) {
        const double angle = 2 * kPi * turns;
        return Plane{std::sqrt(t + 0.5) * std::cos(angle), std::sqrt(t + 0.5) * std::sin(angle)};
    };
    const auto area = [](const Plane& a, const Plane& b, const Plane& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const Plane p = at(std::fmax(n * (1 - q.z) / 2, 0.0) - 0.5, std::atan2(q.y, q.x) / (2 * kPi));
    Weights best;
    double best_smallest = -1e9;
    for (int k = 0; k < detail::polar::kTriangles; ++k) {
        const uint8_t* c = detail::polar::corners(k);
        const Plane a = at(c[0], c[0] / kGolden);
        const Plane b = at(c[1], c[1] / kGolden);
        const Plane d = at(c[2], c[2] / kGolden);
        const double whole = area(a, b, d);
        const double w[3] = {area(b, d, p) / whole, area(d, a, p) / whole, area(a, b, p) / whole};
        const double smallest = std::min({w[0], w[1], w[2]});
        if (smallest > best_smallest) {
            best_smallest = smallest;
            best = {{c[0], w[0]}, {c[1], w[1]}, {c[2], w[2]}};
        }
    }
    return best;
}

double fibonacci(int m)
{
    return std::round(std::pow(kGolden, m) / std::sqrt(5.0));
}

// The zone of a direction, with the part of it that lies behind.
double zone_of(const Vec3& q, uint32_t n)
{
    return std::log(std::sqrt(5.0) * kPi * n * (1 - q.z * q.z)) / std::log(kGolden) / 2;
}

// Lattice coordinates in the basis (F_k, F_k+1).
struct CellCoordinates {
    double u, v;
};

CellCoordinates coordinates(const Vec3& q, uint32_t n, int k)
{
    const double t = n * (1 - q.z) / 2 - 0.5;
    const double turns = std::atan2(q.y, q.x) / (2 * kPi);
    const double sign = k % 2 != 0 ? 1 : -1;
    return {sign * fibonacci(k + 1) * turns + std::pow(kGolden, -k - 1) * t,
            std::pow(kGolden, -k) * t - sign * fibonacci(k) * turns};
}

Weights cell_weights(const Vec3& q, uint32_t n)
{
    const int k = static_cast<int>(std::floor(zone_of(q, n)));
    const auto [u, v] = coordinates(q, n, k);
    const double fu = u - std::floor(u);
    const double fv = v - std::floor(v);
    const double corner = fibonacci(k) * std::floor(u) + fibonacci(k + 1) * std::floor(v);
    const double middle_z = 1 - (2 * corner + fibonacci(k) + fibonacci(k + 1) + 1) / n;
    const bool obtuse = std::sqrt(5.0) * kPi * n * (1 - middle_z * middle_z) >= std::pow(kGolden, 2 * k + 1);
    const auto index = [](double i) { return static_cast<uint32_t>(std::lround(i)); };
    const uint32_t near = index(corner);
    const uint32_t first = index(corner + fibonacci(k));
    const uint32_t second = index(corner + fibonacci(k + 1));
    const uint32_t far = index(corner + fibonacci(k) + fibonacci(k + 1));
    if (obtuse)
        return {{near, 1 - std::max(fu, fv)}, {fu > fv ? first : second, std::fabs(fu - fv)}, {far, std::min(fu, fv)}};
    if (fu + fv < 1) return {{near, 1 - fu - fv}, {first, fu}, {second, fv}};
    return {{far, fu + fv - 1}, {first, 1 - fv}, {second, 1 - fu}};
}

// q, or its mirror image under i -> n-1-i if that is the one in the north.
Vec3 northern(const Vec3& q, uint32_t n)
{
    if (q.z >= 0) return q;
    const double angle = 2 * kPi * ((n - 1) / kGolden) - std::atan2(q.y, q.x);
    const double radius = std::sqrt(q.x * q.x + q.y * q.y);
    return {radius * std::cos(angle), radius * std::sin(angle), -q.z};
}

bool is_polar(const Vec3& north, uint32_t n)
{
    return n * (1 - north.z) / 2 - 0.5 < detail::polar::kPolarHeight;
}

bool near_half(double coordinate, double share)
{
    return std::fabs(coordinate - std::floor(coordinate) - 0.5) < share;
}

uint32_t rounded_index(const CellCoordinates& c, int k)
{
    return static_cast<uint32_t>(
        std::lround(fibonacci(k) * std::floor(c.u + 0.5) + fibonacci(k + 1) * std::floor(c.v + 0.5)));
}

}  // namespace

Weights sorted_by_distance(const std::vector<Vec3>& all, const Vec3& q, uint32_t count)
{
    Weights near;
    for (uint32_t i = 0; i < all.size(); ++i) near.emplace_back(i, dot(all[i] - q, all[i] - q));
    const auto by_distance = [](const auto& a, const auto& b) { return a.second < b.second; };
    const size_t kept = std::min<size_t>(count, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<long>(kept), near.end(), by_distance);
    near.resize(kept);
    return near;
}

Weights nearest_weights(const std::vector<Vec3>& all, const Vec3& q)
{
    return {{sorted_by_distance(all, q, 1)[0].first, 1.0}};
}

CellPoint nearest_point(const std::vector<Vec3>& all, const Vec3& q, double border_share)
{
    const Weights two = sorted_by_distance(all, q, 2);
    const double apart = length(all[two[0].first] - all[two[1].first]);
    const double from_border = (two[1].second - two[0].second) / (2 * apart);
    return {two[0].first, from_border < border_share * spacing(static_cast<uint32_t>(all.size()))};
}

CellPoint cell_point(const std::vector<Vec3>& all, const Vec3& q, double border_share)
{
    const uint32_t n = static_cast<uint32_t>(all.size());
    const Vec3 north = northern(q, n);
    if (is_polar(north, n)) return nearest_point(all, q, border_share);
    const double zone = zone_of(north, n);
    const int k = static_cast<int>(std::floor(zone));
    const CellCoordinates c = coordinates(north, n, k);
    const uint32_t index = rounded_index(c, k);
    bool uncertain = near_half(c.u, border_share) || near_half(c.v, border_share);
    for (const int other :
         {static_cast<int>(std::floor(zone - kZoneShare)), static_cast<int>(std::floor(zone + kZoneShare))})
        uncertain = uncertain || rounded_index(coordinates(north, n, other), other) != index;
    return {q.z < 0 ? n - 1 - index : index, uncertain};
}

Weights paper_weights(const std::vector<Vec3>& all, const Vec3& q, uint32_t count)
{
    Weights near = sorted_by_distance(all, q, count);
    const double radius2 = 4 * kPi / static_cast<double>(all.size());
    double sum = 0;
    for (auto& [i, w] : near) {
        w = std::pow(std::fmax(0.0, 1 - w / radius2), 2);
        sum += w;
    }
    for (auto& [i, w] : near) w /= sum;
    return near;
}

Weights linear_weights(const std::vector<Vec3>& all, const Vec3& q)
{
    const uint32_t n = static_cast<uint32_t>(all.size());
    if (n < kSmallSize) return paper_weights(all, q, 3);
    const Vec3 north = northern(q, n);
    Weights weights = is_polar(north, n) ? polar_weights(north, n) : cell_weights(north, n);
    for (auto& [i, w] : weights) i = q.z < 0 ? n - 1 - i : i;
    return weights;
}

}  // namespace lumi::twin
