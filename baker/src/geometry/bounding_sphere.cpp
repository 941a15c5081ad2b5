// SPDX-License-Identifier: MIT
// Pivoting after Gärtner, "Fast and Robust Smallest Enclosing Balls", ESA 1999: the farthest point joins the support
// set, the support's own smallest sphere is found by trying all its subsets, and so on until nothing is outside.
#include "geometry/bounding_sphere.h"

#include <cassert>
#include <optional>

namespace lumi::baker
{
namespace
{

using Point = std::array<double, 3>;

constexpr double kTolerance = 1e-7;  // as a share of the radius; above binary64's noise on well-conditioned supports
constexpr int kMaxPivots = 200;      // tens suffice; the bound only guards against cycling on rounding

Point to_point(const Vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Point minus(const Point& a, const Point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point& a, const Point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double distance(const Point& a, const Point& b)
{
    const Point d = minus(a, b);
    return std::sqrt(dot(d, d));
}

// Solves the k×k system a·x = b (k <= 3) by elimination with pivoting; nothing if singular.
std::optional<Point> solve(std::array<std::array<double, 4>, 3> rows, size_t k)
{
    for (size_t column = 0; column < k; ++column) {
        size_t best = column;
        for (size_t r = column + 1; r < k; ++r)
            best = std::abs(rows[r][column]) > std::abs(rows[best][column]) ? r : best;
        if (rows[best][column] == 0) return std::nullopt;
        std::swap(rows[column], rows[best]);
        for (size_t r = 0; r < k; ++r) {
            const double factor = r == column ? 0 : rows[r][column] / rows[column][column];
            for (size_t c = column; c < 4; ++c) rows[r][c] -= factor * rows[column][c];
        }
    }
    Point x{};
    for (size_t r = 0; r < k; ++r) x[r] = rows[r][3] / rows[r][r];
    return x;
}

// The sphere through all points of `set` (1 to 4) whose centre lies in their affine hull; nothing if they are
// dependent.
std::optional<BoundingSphere> circumsphere(const std::vector<Point>& set)
{
    const size_t k = set.size() - 1;
    std::array<Point, 3> edges{};
    std::array<std::array<double, 4>, 3> rows{};
    for (size_t r = 0; r < k; ++r) edges[r] = minus(set[r + 1], set[0]);
    for (size_t r = 0; r < k; ++r) {
        for (size_t c = 0; c < k; ++c) rows[r][c] = 2 * dot(edges[r], edges[c]);
        rows[r][3] = dot(edges[r], edges[r]);
    }
    const std::optional<Point> weights = solve(rows, k);
    if (!weights) return std::nullopt;
    Point centre = set[0];
    for (size_t r = 0; r < k; ++r)
        for (size_t axis = 0; axis < 3; ++axis) centre[axis] += (*weights)[r] * edges[r][axis];
    return BoundingSphere{centre, distance(centre, set[0])};
}

bool holds_all(const BoundingSphere& sphere, const std::vector<Point>& points)
{
    for (const Point& p : points)
        if (distance(p, sphere.centre) > sphere.radius * (1 + kTolerance)) return false;
    return true;
}

// The smallest sphere around at most five points, with the at most four of them that carry it.
struct Support {
    std::vector<Point> points;
    BoundingSphere sphere;
};

std::optional<Support> smallest_of_few(const std::vector<Point>& points)
{
    std::optional<Support> best;
    for (unsigned mask = 1; mask < 1u << points.size(); ++mask) {
        std::vector<Point> subset;
        for (size_t k = 0; k < points.size(); ++k)
            if (mask >> k & 1u) subset.push_back(points[k]);
        if (subset.size() > 4) continue;
        const std::optional<BoundingSphere> sphere = circumsphere(subset);
        if (sphere && (!best || sphere->radius < best->sphere.radius) && holds_all(*sphere, points))
            best = Support{subset, *sphere};
    }
    return best;
}

Point farthest_from(const Point& centre, const std::vector<Vec3>& points)
{
    Point best = centre;
    double best_distance = -1;
    for (const Vec3& v : points) {
        const Point p = to_point(v);
        const double d = distance(p, centre);
        if (d > best_distance) {
            best_distance = d;
            best = p;
        }
    }
    return best;
}

}  // namespace

BoundingSphere smallest_sphere(const std::vector<Vec3>& points)
{
    assert(!points.empty());
    Support support = {{to_point(points[0])}, {to_point(points[0]), 0}};
    Point pivot = farthest_from(support.sphere.centre, points);
    for (int k = 0; k < kMaxPivots; ++k) {
        if (distance(pivot, support.sphere.centre) <= support.sphere.radius * (1 + kTolerance)) break;
        std::vector<Point> candidates = support.points;
        candidates.push_back(pivot);
        std::optional<Support> grown = smallest_of_few(candidates);
        if (!grown) break;
        support = std::move(*grown);
        pivot = farthest_from(support.sphere.centre, points);
    }
    return {support.sphere.centre, distance(pivot, support.sphere.centre)};
}

}  // namespace lumi::baker
