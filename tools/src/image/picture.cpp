// SPDX-License-Identifier: MIT
#include "image/picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lumi::tools
{

Picture::Picture(int width, int height, const Rgb8& colour)
    : width_px(width), height_px(height), rgb(3 * static_cast<size_t>(width) * static_cast<size_t>(height))
{
    for (size_t i = 0; i < rgb.size(); i += 3) {
        rgb[i] = colour.r;
        rgb[i + 1] = colour.g;
        rgb[i + 2] = colour.b;
    }
}

void check_precondition(bool holds, const char* what)
{
    if (!holds) throw std::invalid_argument(what);
}

void paste(const Picture& source, int x, int y, Picture& target)
{
    const bool fits =
        x >= 0 && y >= 0 && x + source.width_px <= target.width_px && y + source.height_px <= target.height_px;
    check_precondition(fits, "a picture does not fit into another one");
    for (int row = 0; row < source.height_px; ++row)
        std::copy_n(source.pixel(0, row), 3 * source.width_px, target.pixel(x, y + row));
    if (source.alpha.empty()) return;
    for (int row = 0; row < source.height_px; ++row)
        std::copy_n(source.alpha.begin() + row * source.width_px, source.width_px,
                    target.alpha.begin() + (y + row) * target.width_px + x);
}

std::vector<uint8_t> rgba_of(const Picture& picture)
{
    std::vector<uint8_t> rgba;
    rgba.reserve(4 * picture.alpha.size());
    for (size_t i = 0; i < picture.alpha.size(); ++i) {
        rgba.insert(rgba.end(), &picture.rgb[3 * i], &picture.rgb[3 * i] + 3);
        rgba.push_back(picture.alpha[i]);
    }
    return rgba;
}

Plane<double> luma_plane(const Picture& picture)
{
    constexpr double kRed = 0.299, kGreen = 0.587, kBlue = 0.114;
    Plane<double> plane(picture.width_px, picture.height_px);
    for (size_t i = 0; i < plane.values.size(); ++i) {
        const uint8_t* rgb = &picture.rgb[3 * i];
        plane.values[i] = kRed * rgb[0] + kGreen * rgb[1] + kBlue * rgb[2];
    }
    return plane;
}

namespace
{

int columns_for(int count, int width_px, int height_px)
{
    const double ratio = static_cast<double>(height_px) / width_px;
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(count * ratio)), 1.0, static_cast<double>(count)));
}

int sheet_side(int tiles, int tile_px)
{
    return tiles * tile_px + (tiles - 1) * kSheetGap;
}

int factor_for(int columns, int width_px, int height_px)
{
    int factor = 1;
    while (factor < std::min(width_px, height_px) && sheet_side(columns, width_px / factor) > kSheetMaxWidth) ++factor;
    return factor;
}

// The mean of a block, pixel (x, y) of the smaller picture.
void put_mean(const Picture& picture, int factor, int x, int y, Picture& small)
{
    int64_t sums[3] = {}, weight = 0;
    for (int row = y * factor; row < (y + 1) * factor; ++row)
        for (int column = x * factor; column < (x + 1) * factor; ++column) {
            const int alpha = picture.alpha.empty() ? 1 : picture.alpha_at(column, row);
            for (int k = 0; k < 3; ++k) sums[k] += alpha * picture.pixel(column, row)[k];
            weight += alpha;
        }
    const auto mean = [](int64_t sum, int64_t count) { return static_cast<uint8_t>((sum + count / 2) / count); };
    if (weight != 0)
        for (int k = 0; k < 3; ++k) small.pixel(x, y)[k] = mean(sums[k], weight);
    if (!small.alpha.empty()) small.alpha_at(x, y) = mean(weight, int64_t{factor} * factor);
}

}  // namespace

Picture shrunk(const Picture& picture, int factor)
{
    check_precondition(factor >= 1 && factor <= picture.width_px && factor <= picture.height_px,
                       "a picture cannot become smaller than a pixel");
    Picture small(picture.width_px / factor, picture.height_px / factor);
    if (!picture.alpha.empty()) small.alpha.resize(small.rgb.size() / 3);
    for (int y = 0; y < small.height_px; ++y)
        for (int x = 0; x < small.width_px; ++x) put_mean(picture, factor, x, y, small);
    return small;
}

ContactSheet::ContactSheet(int count, int width_px, int height_px, const Rgb8& background, bool is_opaque)
    : columns_(columns_for(count, width_px, height_px)), factor_(factor_for(columns_, width_px, height_px))
{
    const int rows = (count + columns_ - 1) / columns_;
    sheet_ = Picture(sheet_side(columns_, width_px / factor_), sheet_side(rows, height_px / factor_), background);
    if (!is_opaque) sheet_.alpha.resize(sheet_.rgb.size() / 3);
}

void ContactSheet::add(const Picture& picture)
{
    const Picture tile = shrunk(picture, factor_);
    paste(tile, added_ % columns_ * (tile.width_px + kSheetGap), added_ / columns_ * (tile.height_px + kSheetGap),
          sheet_);
    ++added_;
}

}  // namespace lumi::tools
