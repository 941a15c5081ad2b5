// SPDX-License-Identifier: MIT
// Vectors and linear colours of the path tracer, in binary32. The traced scene lives in the frame of the unit sphere,
// so lengths are of the order of 1.
#pragma once

#include <algorithm>
#include <cmath>

#include "lumi/detail/math.h"

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

// Holds linear radiance or reflectance by Rec. 709 primaries.
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

// Makes a point of core's lattices a vector of the baker's.
inline Vec3 unit_vector(const Vec3q30& p)
{
    constexpr double kUnit = 1.0 / kOneQ30;
    return normalized(
        {static_cast<float>(p.x * kUnit), static_cast<float>(p.y * kUnit), static_cast<float>(p.z * kUnit)});
}

// Makes an orthonormal frame around a unit vector, continuous but for one seam and exact at the poles.
// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
struct Frame {
    Vec3 tangent, bitangent, normal;

    explicit Frame(const Vec3& n) : normal(n)
    {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1 / (sign + n.z);
        const float b = n.x * n.y * a;
        tangent = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        bitangent = {b, sign + n.y * n.y * a, -n.y};
    }

    // With the tangent as near to `along` as can be; any tangent where `along` is not across n.
    Frame(const Vec3& n, const Vec3& along) : Frame(n)
    {
        const Vec3 across = along - n * dot(n, along);
        const float size = length(across);
        if (size > 0) {
            tangent = across / size;
            bitangent = cross(n, tangent);
        }
    }

    Vec3 to_local(const Vec3& v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
    Vec3 to_world(const Vec3& v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
};

}  // namespace lumi::baker
