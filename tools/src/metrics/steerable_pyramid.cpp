// SPDX-License-Identifier: MIT
#include "metrics/steerable_pyramid.h"

#include <algorithm>
#include <cmath>

#include "metrics/pi.h"

namespace lumi::tools
{

namespace
{

constexpr double kNyquist = 0.5;  // cycles per pixel

// Octaves of `frequency` below `cutoff`, clamped to 0 .. 1: a filter's transition from stop to pass is one octave wide.
double octave_below(double frequency, double cutoff)
{
    return frequency <= 0 ? 1 : std::clamp(std::log2(cutoff / frequency), 0.0, 1.0);
}

// The scale that makes the squared cosine powers of all orientations sum to 1: with n = kOrientations - 1,
// 2^n · n! / sqrt(kOrientations · (2n)!).
double angular_scale()
{
    constexpr double kPower = kOrientations - 1;
    const double log_scale = kPower * std::log(2.0) + std::lgamma(kPower + 1) -
                             (std::log(static_cast<double>(kOrientations)) + std::lgamma(2 * kPower + 1)) / 2;
    return std::exp(log_scale);
}

// The signed frequency index of column or row i.
int signed_index(int i, int side)
{
    return i < (side + 1) / 2 ? i : i - side;
}

int wrapped(int index, int side)
{
    return index < 0 ? index + side : index;
}

}  // namespace

double radial_factor(int level, double fx, double fy)
{
    const double frequency = std::hypot(fx, fy);
    const double cutoff = std::ldexp(kNyquist, -level);
    const double low_pass = std::sin(kPi / 2 * octave_below(frequency, cutoff));
    const double high_pass = std::cos(kPi / 2 * octave_below(frequency, cutoff / 2));
    return low_pass * high_pass;
}

double angular_factor(int orientation, double fx, double fy)
{
    static const double scale = angular_scale();
    const double angle = kPi * orientation / kOrientations;
    const double length = std::hypot(fx, fy);
    const double cosine = length > 0 ? (fx * std::cos(angle) + fy * std::sin(angle)) / length : 0;
    return cosine > 0 ? scale * std::pow(cosine, kOrientations - 1) : 0;
}

SteerablePyramid::SteerablePyramid(const Plane<double>& plane) : spectrum_(forward_transform(plane)) {}

Plane<Complex> SteerablePyramid::band(int level, int orientation) const
{
    const int width = spectrum_.width_px, height = spectrum_.height_px;
    // A real picture has half its energy in each half plane; twice one half gives the amplitude of the whole.
    const double scale = 2.0 / (static_cast<double>(width) * height);
    Plane<Complex> cropped(band_side(width, level), band_side(height, level));
    for (int y = 0; y < cropped.height_px; ++y) {
        const int v = signed_index(y, cropped.height_px);
        for (int x = 0; x < cropped.width_px; ++x) {
            const int u = signed_index(x, cropped.width_px);
            const double fx = static_cast<double>(u) / width, fy = static_cast<double>(v) / height;
            const double factor = radial_factor(level, fx, fy) * angular_factor(orientation, fx, fy);
            cropped.at(x, y) = scale * factor * spectrum_.at(wrapped(u, width), wrapped(v, height));
        }
    }
    return inverse_transform(std::move(cropped));
}

}  // namespace lumi::tools
