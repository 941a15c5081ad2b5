// SPDX-License-Identifier: MIT
#include "image/picture.h"

#include <algorithm>
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
}

}  // namespace lumi::tools
