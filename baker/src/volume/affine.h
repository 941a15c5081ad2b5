// SPDX-License-Identifier: MIT
// Affine maps of space, as rows of 3×4 numbers.
#pragma once

#include <array>

#include "math/vec3.h"

namespace lumi::baker
{

using Affine = std::array<std::array<double, 4>, 3>;

inline constexpr Affine kIdentity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

inline std::array<double, 3> point_of(const Affine& m, double x, double y, double z)
{
    std::array<double, 3> result;
    for (size_t r = 0; r < 3; ++r) result[r] = m[r][0] * x + m[r][1] * y + m[r][2] * z + m[r][3];
    return result;
}

inline std::array<double, 3> in_doubles(const Vec3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Vec3 in_floats(const std::array<double, 3>& v)
{
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

inline Vec3 moved(const Affine& m, const Vec3& p)
{
    const std::array<double, 3> v = in_doubles(p);
    return in_floats(point_of(m, v[0], v[1], v[2]));
}

inline Vec3 direction_of(const Affine& m, const Vec3& direction)
{
    return moved(m, direction) - moved(m, {});
}

// Applies first b, then a.
inline Affine combined(const Affine& a, const Affine& b)
{
    Affine result;
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 4; ++c)
            result[r][c] = a[r][0] * b[0][c] + a[r][1] * b[1][c] + a[r][2] * b[2][c] + (c == 3 ? a[r][3] : 0);
    return result;
}

// The volume, with its sign, that a unit cube gets.
inline double determinant(const Affine& m)
{
    double sum = 0;
    for (size_t c = 0; c < 3; ++c)
        sum += m[0][c] * (m[1][(c + 1) % 3] * m[2][(c + 2) % 3] - m[1][(c + 2) % 3] * m[2][(c + 1) % 3]);
    return sum;
}

// The map's determinant is not 0.
inline Affine inverse(const Affine& m)
{
    const double scale = 1 / determinant(m);
    Affine result{};
    for (size_t r = 0; r < 3; ++r) {
        for (size_t c = 0; c < 3; ++c) {
            const size_t a = (c + 1) % 3, b = (c + 2) % 3, d = (r + 1) % 3, e = (r + 2) % 3;
            result[r][c] = scale * (m[a][d] * m[b][e] - m[a][e] * m[b][d]);
        }
    }
    for (size_t r = 0; r < 3; ++r)
        result[r][3] = -(result[r][0] * m[0][3] + result[r][1] * m[1][3] + result[r][2] * m[2][3]);
    return result;
}

}  // namespace lumi::baker
