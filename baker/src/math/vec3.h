// SPDX-License-Identifier: MIT
// Vectors and linear colours of the path tracer, in binary32. The traced scene lives in the frame of the unit sphere,
// so lengths are of the order of 1.
#pragma once

#include <algorithm>
#include <cmath>

namespace lumi::baker
{

inline constexpr float kPi = 3.14159265358979323846f;

struct Vec2 {
    float x = 0, y = 0;
};

struct Vec3 {
    float x = 0, y = 0, z = 0;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(const Vec3& a, const Vec3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(const Vec3& a)
{
    return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(const Vec3& a, float s)
{
    return {a.x * s, a.y * s, a.z * s};
}
constexpr Vec3 operator*(float s, const Vec3& a)
{
    return a * s;
}
constexpr Vec3 operator/(const Vec3& a, float s)
{
    return a * (1 / s);
}

constexpr float dot(const Vec3& a, const Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vec3& a)
{
    return std::sqrt(dot(a, a));
}
inline Vec3 normalized(const Vec3& a)
{
    return a / length(a);
}

// Linear radiance or reflectance, Rec. 709 primaries.
struct Rgb {
    float r = 0, g = 0, b = 0;
};

inline constexpr float kMaxRadiance = 1e9f;  // the most that a scene may hold: sums of many stay finite in binary32

constexpr Rgb grey(float v)
{
    return {v, v, v};
}
constexpr Rgb operator+(const Rgb& a, const Rgb& b)
{
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Rgb operator-(const Rgb& a, const Rgb& b)
{
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Rgb operator*(const Rgb& a, const Rgb& b)
{
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Rgb operator/(const Rgb& a, const Rgb& b)
{
    return {a.r / b.r, a.g / b.g, a.b / b.b};
}
constexpr Rgb operator*(const Rgb& a, float s)
{
    return {a.r * s, a.g * s, a.b * s};
}
constexpr Rgb operator*(float s, const Rgb& a)
{
    return a * s;
}

constexpr float max_component(const Rgb& c)
{
    return std::max({c.r, c.g, c.b});
}
constexpr float luminance(const Rgb& c)
{
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}
constexpr bool is_black(const Rgb& c)
{
    return c.r <= 0 && c.g <= 0 && c.b <= 0;
}

// The members that files of a bake hold (byte_stream.h).
template <class Io>
void fields(Io& io, Vec3& v)
{
    io(v.x, v.y, v.z);
}
template <class Io>
void fields(Io& io, Rgb& c)
{
    io(c.r, c.g, c.b);
}

}  // namespace lumi::baker
