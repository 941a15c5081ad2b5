// SPDX-License-Identifier: MIT
// Area-preserving maps from the unit square [0,1)² to where samples are needed.
#pragma once

#include "math/vec3.h"

namespace lumi::baker
{

struct SineCosine {
    float sine, cosine;
};

// For |x| <= π/4, by the series up to x^9: off by at most 1e-7. The C library's is slower, and chooses its code, and so
// the last bit, by the processor.
inline SineCosine sine_cosine_near_zero(float x)
{
    const float x2 = x * x;
    return {x * (1 + x2 * (-1.0f / 6 + x2 * (1.0f / 120 + x2 * (-1.0f / 5040 + x2 * (1.0f / 362880))))),
            1 + x2 * (-1.0f / 2 + x2 * (1.0f / 24 + x2 * (-1.0f / 720 + x2 * (1.0f / 40320))))};
}

inline SineCosine sine_cosine_of_turns(float turns)
{
    const float quarters = std::floor(4 * turns + 0.5f);
    const SineCosine s = sine_cosine_near_zero(2 * kPi * (turns - 0.25f * quarters));
    switch (static_cast<int>(quarters) & 3) {
        case 0:
            return s;
        case 1:
            return {s.cosine, -s.sine};
        case 2:
            return {-s.sine, -s.cosine};
        default:
            return {-s.cosine, s.sine};
    }
}

// Uniform on the unit disc; neighbours stay neighbours, which keeps stratification. Shirley & Chiu, "A Low Distortion
// Map Between Disk and Square", JGT 2(3), 1997.
inline Vec2 square_to_disc(const Vec2& u)
{
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b;
    const SineCosine s = sine_cosine_near_zero(kPi / 4 * (wide ? b / a : a / b));
    return wide ? Vec2{radius * s.cosine, radius * s.sine} : Vec2{radius * s.sine, radius * s.cosine};
}

// Samples have the density cosθ/π over the upper hemisphere (Malley's method).
inline Vec3 square_to_cosine_hemisphere(const Vec2& u)
{
    const Vec2 d = square_to_disc(u);
    return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}

// A direction from the height z and an angle in turns.
inline Vec3 direction_at(float z, float turns)
{
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    const SineCosine s = sine_cosine_of_turns(turns);
    return {r * s.cosine, r * s.sine, z};
}

inline Vec3 square_to_sphere(const Vec2& u)
{
    return direction_at(1 - 2 * u.x, u.y);
}

// Returns barycentric weights (of the second and third corner) of a uniform point in a triangle.
inline Vec2 square_to_triangle(const Vec2& u)
{
    const float root = std::sqrt(u.x);
    return {1 - root, u.y * root};
}

}  // namespace lumi::baker
