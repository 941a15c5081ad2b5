// SPDX-License-Identifier: MIT
#include "metrics/spectrum.h"

#include <algorithm>
#include <kissfft/kissfft.hh>

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

}  // namespace lumi::tools
