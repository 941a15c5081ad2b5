// SPDX-License-Identifier: MIT
// Core computes with these fixed-point numbers.
//
// Formats are part of names: `x_q30` holds x·2^30 in an int32_t. Angles are fractions of a turn in a uint32_t
// (`_turns32`, 2^32 = one turn), so that they wrap for free. Products narrow with rounding to nearest.
// Cost: one 32×32→64 multiply; on Cortex-M0+ that is a library call, keep it out of inner loops there.
#pragma once
#pragma GCC system_header

#include <stdint.h>

#include "lumi/detail/compiler.h"

namespace lumi
{

inline constexpr int32_t kOneQ30 = int32_t{1} << 30;
inline constexpr int32_t kOneQ20 = int32_t{1} << 20;

// This is a direction or a point in the frame of the unit sphere (z up), components in [-1, 1].
struct Vec3q30 {
    int32_t x, y, z;
};

// This is a point in units of the sphere's radius, components in [-2048, 2048).
struct Vec3q20 {
    int32_t x, y, z;
};

// Holds sin and cos of an angle, Q30. The absolute error is below 2^-28.
struct SinCos {
    int32_t sin_q30, cos_q30;
};
SinCos sin_cos(uint32_t angle_turns32);

}  // namespace lumi

namespace lumi::detail
{

constexpr int32_t magnitude(int32_t v)
{
    return v < 0 ? -v : v;
}

constexpr int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

constexpr int64_t wide_product(int32_t a, int32_t b)
{
    return static_cast<int64_t>(a) * b;
}

// Returns the square of a vector's length, Q40, whatever its components.
constexpr uint64_t length2_q40(const Vec3q20& v)
{
    return static_cast<uint64_t>(wide_product(v.x, v.x)) + static_cast<uint64_t>(wide_product(v.y, v.y)) +
           static_cast<uint64_t>(wide_product(v.z, v.z));
}

// Rounds a Q60 product to Q30. |value| must stay below 2 - 2^-31.
constexpr int32_t q60_to_q30(int64_t value_q60)
{
    return static_cast<int32_t>((value_q60 + (int64_t{1} << 29)) >> 30);
}

constexpr int32_t mul_q30(int32_t a_q30, int32_t b_q30)
{
    return q60_to_q30(wide_product(a_q30, b_q30));
}

// Returns the Q60 dot product; three products of vectors up to length sqrt(2.6) fit.
constexpr int64_t dot_q60(const Vec3q30& a, const Vec3q30& b)
{
    return wide_product(a.x, b.x) + wide_product(a.y, b.y) + wide_product(a.z, b.z);
}

constexpr int32_t dot_q30(const Vec3q30& a, const Vec3q30& b)
{
    return q60_to_q30(dot_q60(a, b));
}

}  // namespace lumi::detail
