// SPDX-License-Identifier: MIT
// Ear clipping after Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975.
#include "geometry/polygon.h"

namespace lumi::baker
{
namespace
{

struct Flat {
    double x, y;
};

double cross2(const Flat& a, const Flat& b, const Flat& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Newell's normal: right for concave and slightly bent polygons too.
std::array<double, 3> newell_normal(const std::vector<Vec3>& p)
{
    std::array<double, 3> n{};
    const Vec3& base = p[0];
    for (size_t k = 0; k < p.size(); ++k) {
        const Vec3 a = p[k] - base;
        const Vec3 b = p[(k + 1) % p.size()] - base;
        n[0] += (static_cast<double>(a.y) - static_cast<double>(b.y)) *
                (static_cast<double>(a.z) + static_cast<double>(b.z));
        n[1] += (static_cast<double>(a.z) - static_cast<double>(b.z)) *
                (static_cast<double>(a.x) + static_cast<double>(b.x));
        n[2] += (static_cast<double>(a.x) - static_cast<double>(b.x)) *
                (static_cast<double>(a.y) + static_cast<double>(b.y));
    }
    return n;
}

// Drops the axis along which the polygon is thinnest, so that it stays counter-clockwise.
std::vector<Flat> flattened(const std::vector<Vec3>& p)
{
    const std::array<double, 3> n = newell_normal(p);
    size_t axis = 0;
    for (size_t k = 1; k < 3; ++k) axis = std::abs(n[k]) > std::abs(n[axis]) ? k : axis;
    std::vector<Flat> flat;
    for (const Vec3& v : p) {
        const std::array<double, 3> c = {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
        const double a = c[(axis + 1) % 3];
        const double b = c[(axis + 2) % 3];
        flat.push_back(n[axis] < 0 ? Flat{b, a} : Flat{a, b});
    }
    return flat;
}

bool inside(const Flat& p, const Flat& a, const Flat& b, const Flat& c)
{
    return cross2(a, b, p) >= 0 && cross2(b, c, p) >= 0 && cross2(c, a, p) >= 0;
}

bool same(const Flat& a, const Flat& b)
{
    return a.x == b.x && a.y == b.y;
}

bool is_ear(const std::vector<Flat>& flat, const std::vector<uint32_t>& ring, size_t at)
{
    const Flat& a = flat[ring[(at + ring.size() - 1) % ring.size()]];
    const Flat& b = flat[ring[at]];
    const Flat& c = flat[ring[(at + 1) % ring.size()]];
    if (cross2(a, b, c) <= 0) return false;
    for (const uint32_t k : ring) {
        const Flat& p = flat[k];
        if (!same(p, a) && !same(p, b) && !same(p, c) && inside(p, a, b, c)) return false;
    }
    return true;
}

// Turns left at each corner, and once around in all: then it goes right at most once, and left at most once.
bool is_convex(const std::vector<Flat>& flat)
{
    const size_t n = flat.size();
    size_t changes = 0;
    for (size_t k = 0; k < n; ++k) {
        const Flat &a = flat[k], &b = flat[(k + 1) % n], &c = flat[(k + 2) % n];
        if (!(cross2(a, b, c) > 0)) return false;
        changes += (b.x > a.x) != (c.x > b.x) ? 1u : 0u;
    }
    return changes <= 2;
}

// The triangles that cutting ears makes of a convex polygon.
std::vector<std::array<uint32_t, 3>> fan(uint32_t corners)
{
    std::vector<std::array<uint32_t, 3>> triangles;
    for (uint32_t k = 2; k < corners; ++k) triangles.push_back({0, k - 1, k});
    return triangles;
}

}  // namespace

std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<Vec3>& corners)
{
    std::vector<std::array<uint32_t, 3>> triangles;
    const std::vector<Flat> flat = flattened(corners);
    if (corners.size() > kMostEars || is_convex(flat)) return fan(static_cast<uint32_t>(corners.size()));
    std::vector<uint32_t> ring;
    for (uint32_t k = 0; k < corners.size(); ++k) ring.push_back(k);
    while (ring.size() >= 3) {
        size_t tried = 0;
        while (tried < ring.size() && !is_ear(flat, ring, (tried + 1) % ring.size())) ++tried;
        // Corner 1 first, so that a triangle keeps its order. No ear: crossing or flat, cut anywhere.
        const size_t ear = (tried + 1) % ring.size();
        triangles.push_back({ring[(ear + ring.size() - 1) % ring.size()], ring[ear], ring[(ear + 1) % ring.size()]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
    constexpr double kThinnest = 1e-12;  // sine² of the angle between two edges; below binary32's grid
    const double e[3] = {static_cast<double>(b.x) - static_cast<double>(a.x),
                         static_cast<double>(b.y) - static_cast<double>(a.y),
                         static_cast<double>(b.z) - static_cast<double>(a.z)};
    const double f[3] = {static_cast<double>(c.x) - static_cast<double>(a.x),
                         static_cast<double>(c.y) - static_cast<double>(a.y),
                         static_cast<double>(c.z) - static_cast<double>(a.z)};
    const double n[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    const double product = (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) * (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    return !(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > kThinnest * product);
}

}  // namespace lumi::baker
