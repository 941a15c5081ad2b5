// SPDX-License-Identifier: MIT
#include "lumi/reference/weights.h"

#include <algorithm>

#include "polar.h"

namespace lumi::reference
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
    for (int k = 0; k < polar::kTriangles; ++k) {
        const uint8_t* c = polar::corners(k);
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

Weights cell_weights(const Vec3& q, uint32_t n)
{
    const double phi = kGolden;
    const double t = n * (1 - q.z) / 2 - 0.5;
    const double turns = std::atan2(q.y, q.x) / (2 * kPi);
    const double phi_power = [&] {
        const double x = std::sqrt(5.0) * kPi * n * (1 - q.z * q.z);
        return std::log(x) / std::log(phi);
    }();
    const int k = static_cast<int>(std::floor(phi_power / 2));
    const auto fibonacci = [&](int m) { return std::round(std::pow(phi, m) / std::sqrt(5.0)); };
    const double sign = k % 2 != 0 ? 1 : -1;
    const double u = sign * fibonacci(k + 1) * turns + std::pow(phi, -k - 1) * t;
    const double v = std::pow(phi, -k) * t - sign * fibonacci(k) * turns;
    const double fu = u - std::floor(u);
    const double fv = v - std::floor(v);
    const double corner = fibonacci(k) * std::floor(u) + fibonacci(k + 1) * std::floor(v);
    const double middle_z = 1 - (2 * corner + fibonacci(k) + fibonacci(k + 1) + 1) / n;
    const bool obtuse = std::sqrt(5.0) * kPi * n * (1 - middle_z * middle_z) >= std::pow(phi, 2 * k + 1);
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
    const bool south = q.z < 0;
    const double turns = (n - 1) / kGolden - std::atan2(q.y, q.x) / (2 * kPi);
    const double radius = std::sqrt(q.x * q.x + q.y * q.y);
    const Vec3 north = south ? Vec3{radius * std::cos(2 * kPi * turns), radius * std::sin(2 * kPi * turns), -q.z} : q;
    Weights weights =
        n * (1 - north.z) / 2 - 0.5 < polar::kCapHeight ? polar_weights(north, n) : cell_weights(north, n);
    for (auto& [i, w] : weights) i = south ? n - 1 - i : i;
    return weights;
}

}  // namespace lumi::reference
