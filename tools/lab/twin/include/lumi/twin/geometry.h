// SPDX-License-Identifier: MIT
// This computes what core computes, in double precision and by other means: brute force in place of inverse maps, the
// plain quadratic equation in place of the renderer's stable form.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "lumi/camera.h"
#include "lumi/detail/lattice.h"

namespace lumi::twin
{

inline const double kPi = std::acos(-1.0);
inline const double kGolden = (1 + std::sqrt(5.0)) / 2;

struct Vec3 {
    double x, y, z;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double s, const Vec3& v)
{
    return {s * v.x, s * v.y, s * v.z};
}
inline double dot(const Vec3& a, const Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double length(const Vec3& v)
{
    return std::sqrt(dot(v, v));
}
inline Vec3 normalised(const Vec3& v)
{
    return (1 / length(v)) * v;
}

inline double from_q30(int64_t v)
{
    return static_cast<double>(v) / kOneQ30;
}
inline Vec3 decoded(const Vec3q30& v)
{
    return {from_q30(v.x), from_q30(v.y), from_q30(v.z)};
}
inline Vec3 decoded(const Vec3q20& v)
{
    return {v.x / 1048576.0, v.y / 1048576.0, v.z / 1048576.0};
}
inline int32_t to_q30(double v)
{
    return static_cast<int32_t>(std::lround(v * kOneQ30));
}
inline Vec3q30 encoded(const Vec3& v)
{
    return {to_q30(v.x), to_q30(v.y), to_q30(v.z)};
}

// Computes point i of n, from the definition in lattice.h.
inline Vec3 point(uint32_t n, uint32_t i)
{
    const double z = 1 - (2.0 * i + 1) / n;
    const double turns = i / kGolden;
    const double angle = 2 * kPi * (turns - std::floor(turns));
    const double radius = std::sqrt(std::fmax(0.0, 1 - z * z));
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

inline std::vector<Vec3> points(uint32_t n)
{
    std::vector<Vec3> all(n);
    for (uint32_t i = 0; i < n; ++i) all[i] = point(n, i);
    return all;
}

inline double spacing(uint32_t n)
{
    return std::sqrt(4 * kPi / n);
}

}  // namespace lumi::twin
