// SPDX-License-Identifier: MIT
// Formulas behind core's constant tables, for the compiler only: floating point here never reaches an object file
// (a test reads the symbols). Accuracy: within 1e-14 on the ranges stated.
#pragma once

namespace lumi::detail::generate
{

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kGolden = 1.61803398874989484820;

constexpr double root(double v)
{
    double r = v < 1 ? 1 : v;
    for (int i = 0; i < 64; ++i) r = 0.5 * (r + v / r);
    return r;
}

// |x| <= 2π.
constexpr double sine(double x)
{
    double term = x;
    double sum = x;
    for (int k = 1; k < 24; ++k) {
        term *= -x * x / ((2 * k) * (2 * k + 1));
        sum += term;
    }
    return sum;
}

// Computes atan(x) = 2·atan(x / (1 + sqrt(1 + x²))) until the series converges fast; 0 <= x <= 1.
constexpr double arc_tangent(double x)
{
    double scale = 1;
    for (int i = 0; i < 3; ++i) {
        x = x / (1 + root(1 + x * x));
        scale *= 2;
    }
    double power = x;
    double sum = x;
    for (int k = 1; k < 24; ++k) {
        power *= -x * x;
        sum += power / (2 * k + 1);
    }
    return scale * sum;
}

// x >= 0.
constexpr double fraction(double x)
{
    return x - static_cast<double>(static_cast<long long>(x));
}

}  // namespace lumi::detail::generate
