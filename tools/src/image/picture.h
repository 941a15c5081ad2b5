// SPDX-License-Identifier: MIT
// The tools handle pictures so: 8 bits a channel, sRGB-encoded, no padding, top row first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lumi/color.h"

namespace lumi::tools
{

inline constexpr int kOpaque = 255;

struct Picture {
    int width_px = 0, height_px = 0;
    std::vector<uint8_t> rgb;    // 3 · width · height bytes; not multiplied by alpha
    std::vector<uint8_t> alpha;  // width · height bytes, or none where every pixel is opaque

    Picture() = default;
    Picture(int width, int height, const Rgb8& colour = {0, 0, 0});

    uint8_t* pixel(int x, int y) { return rgb.data() + 3 * index(x, y); }
    const uint8_t* pixel(int x, int y) const { return rgb.data() + 3 * index(x, y); }
    // Precondition: there is alpha.
    uint8_t& alpha_at(int x, int y) { return alpha[index(x, y)]; }
    const uint8_t& alpha_at(int x, int y) const { return alpha[index(x, y)]; }

private:
    size_t index(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width_px) + static_cast<size_t>(x);
    }
};

// Throws std::invalid_argument unless it holds. Sizes of pictures come from files of strangers, so that builds without
// assert() need this, too.
void check_precondition(bool holds, const char* what);

inline bool same_size(const Picture& a, const Picture& b)
{
    return a.width_px == b.width_px && a.height_px == b.height_px;
}

// Computes c + (255 - a)·b/255, rounded, of one channel, in encoded values.
constexpr uint8_t over(uint8_t premultiplied, uint8_t coverage, uint8_t background)
{
    const int value = premultiplied + ((kOpaque - coverage) * background + kOpaque / 2) / kOpaque;
    return static_cast<uint8_t>(value > kOpaque ? kOpaque : value);
}

// Four bytes a pixel, of a picture that has alpha.
std::vector<uint8_t> rgba_of(const Picture& picture);

// Copies `source` into `target` with its top left corner at (x, y). Preconditions: it fits; both have alpha, or
// neither.
void paste(const Picture& source, int x, int y, Picture& target);

// Single-channel images of any value type, on which the structural metrics work.

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

// `factor` × `factor` pixels become one, by their rounded mean, in which a colour counts by its alpha; what is left
// over at the right and bottom is dropped. Precondition: 1 <= factor <= both sides.
Picture shrunk(const Picture& picture, int factor);

inline constexpr int kSheetGap = 4;
inline constexpr int kSheetMaxWidth = 2400;

// A grid of `count` equal pictures, row by row, about as wide as high, kSheetGap apart on the background, which is
// nothing where `is_opaque` is false: then all pictures have alpha, else none. Every picture is shrunk by a whole
// factor while the sheet would be wider than kSheetMaxWidth. Holds the sheet alone, not the pictures.
class ContactSheet
{
public:
    // Precondition: count, width and height are at least 1.
    ContactSheet(int count, int width_px, int height_px, const Rgb8& background, bool is_opaque = true);

    // Puts the next picture in place. Precondition: of the announced size, at most `count` of them.
    void add(const Picture& picture);
    const Picture& picture() const { return sheet_; }

private:
    int columns_, factor_, added_ = 0;
    Picture sheet_;
};

}  // namespace lumi::tools
