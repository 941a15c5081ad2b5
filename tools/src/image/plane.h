// SPDX-License-Identifier: MIT
// Single-channel images of any value type, on which the structural metrics work.
#pragma once

#include <cstddef>
#include <vector>

#include "image/picture.h"

namespace lumi::tools
{

template <class Value>
struct Plane {
    int width_px = 0, height_px = 0;
    std::vector<Value> values;  // width · height, top row first

    Plane() = default;
    Plane(int width, int height)
        : width_px(width), height_px(height), values(static_cast<size_t>(width) * static_cast<size_t>(height))
    {
    }

    Value& at(int x, int y) { return values[index(x, y)]; }
    const Value& at(int x, int y) const { return values[index(x, y)]; }

private:
    size_t index(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width_px) + static_cast<size_t>(x);
    }
};

// Which pixels count: those that are not zero.
using Mask = Plane<uint8_t>;

// Luma by ITU-R BT.601 weights without rounding, 0 .. 255; not core's 8-bit BT.709 luma: the published SSIM and CW-SSIM
// figures are computed so, and 8-bit rounding would add noise to both.
Plane<double> luma_plane(const Picture& picture);

// Filters with the separable window w(x)·w(y); only windows wholly inside count, so each side shrinks by
// weights.size() - 1. Precondition: the plane is at least as large as the window.
template <class Value>
Plane<Value> filter_valid(const Plane<Value>& plane, const std::vector<double>& weights)
{
    const int side = static_cast<int>(weights.size());
    Plane<Value> rows(plane.width_px - side + 1, plane.height_px);
    for (int y = 0; y < rows.height_px; ++y)
        for (int x = 0; x < rows.width_px; ++x)
            for (int i = 0; i < side; ++i) rows.at(x, y) += weights[static_cast<size_t>(i)] * plane.at(x + i, y);
    Plane<Value> result(rows.width_px, plane.height_px - side + 1);
    for (int y = 0; y < result.height_px; ++y)
        for (int i = 0; i < side; ++i)
            for (int x = 0; x < result.width_px; ++x)
                result.at(x, y) += weights[static_cast<size_t>(i)] * rows.at(x, y + i);
    return result;
}

}  // namespace lumi::tools
