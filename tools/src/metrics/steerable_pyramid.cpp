// SPDX-License-Identifier: MIT
#include "metrics/steerable_pyramid.h"

#include <algorithm>
#include <cmath>
#include <kissfft/kissfft.hh>

#include "math/pi.h"

namespace lumi::tools
{

namespace
{

using Transform = kissfft<double>;
constexpr bool kForward = false, kInverse = true;

// Rows, then columns.
Plane<Complex> transformed(Plane<Complex> plane, bool direction)
{
    const size_t width = static_cast<size_t>(plane.width_px), height = static_cast<size_t>(plane.height_px);
    std::vector<Complex> line(std::max(width, height)), out(line.size());
    Transform along_rows(width, direction), along_columns(height, direction);
    for (size_t y = 0; y < height; ++y) {
        Complex* const row = plane.values.data() + y * width;
        along_rows.transform(row, out.data());
        std::copy_n(out.begin(), width, row);
    }
    for (size_t x = 0; x < width; ++x) {
        for (size_t y = 0; y < height; ++y) line[y] = plane.values[y * width + x];
        along_columns.transform(line.data(), out.data());
        for (size_t y = 0; y < height; ++y) plane.values[y * width + x] = out[y];
    }
    return plane;
}

}  // namespace

Plane<Complex> forward_transform(const Plane<double>& plane)
{
    Plane<Complex> complex(plane.width_px, plane.height_px);
    std::copy(plane.values.begin(), plane.values.end(), complex.values.begin());
    return transformed(std::move(complex), kForward);
}

Plane<Complex> inverse_transform(Plane<Complex> spectrum)
{
    return transformed(std::move(spectrum), kInverse);
}

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
