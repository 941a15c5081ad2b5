// SPDX-License-Identifier: MIT
// Area-preserving maps from the unit square [0,1)² to where samples are needed.
#pragma once

#include "vec3.h"

namespace lumi::baker
{

// Uniform on the unit disc; neighbours stay neighbours, which keeps stratification. Shirley & Chiu, "A Low Distortion
// Map Between Disk and Square", JGT 2(3), 1997.
inline Vec2 square_to_disc(const Vec2& u)
{
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    if (a == 0 && b == 0) {
        return {0, 0};
    }
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const float angle = wide ? kPi / 4 * (b / a) : kPi / 2 - kPi / 4 * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Density cosθ/π over the upper hemisphere (Malley's method).
inline Vec3 square_to_cosine_hemisphere(const Vec2& u)
{
    const Vec2 d = square_to_disc(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

// A direction from the height z and an angle in turns.
inline Vec3 direction_at(float z, float turns)
{
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(2 * kPi * turns), r * std::sin(2 * kPi * turns), z};
}

inline Vec3 square_to_sphere(const Vec2& u)
{
    return direction_at(1 - 2 * u.x, u.y);
}

// Barycentric weights (of the second and third corner) of a uniform point in a triangle.
inline Vec2 square_to_triangle(const Vec2& u)
{
    const float root = std::sqrt(u.x);
    return {1 - root, u.y * root};
}

}  // namespace lumi::baker
