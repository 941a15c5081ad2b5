// SPDX-License-Identifier: MIT
#include "texture.h"

#include "srgb.h"

namespace lumi::baker
{
namespace
{

int wrapped(int64_t i, int size)
{
    const int64_t r = i % size;
    return static_cast<int>(r < 0 ? r + size : r);
}

Rgb pixel(const Texture& t, int64_t x, int64_t y)
{
    const size_t row = static_cast<size_t>(wrapped(y, t.height)) * static_cast<size_t>(t.width);
    const uint8_t* p = &t.rgb[3 * (row + static_cast<size_t>(wrapped(x, t.width)))];
    return {srgb_decode(p[0]), srgb_decode(p[1]), srgb_decode(p[2])};
}

}  // namespace

Rgb Texture::at(const Vec2& uv) const
{
    // Only the fraction counts; taken in double so that far-off coordinates keep their pixel.
    const double u = uv.x - std::floor(static_cast<double>(uv.x));
    const double v = uv.y - std::floor(static_cast<double>(uv.y));
    const double x = u * width - 0.5;
    const double y = (1 - v) * height - 0.5;
    const int64_t x0 = static_cast<int64_t>(std::floor(x));
    const int64_t y0 = static_cast<int64_t>(std::floor(y));
    const float fx = static_cast<float>(x - static_cast<double>(x0));
    const float fy = static_cast<float>(y - static_cast<double>(y0));
    const Rgb top = pixel(*this, x0, y0) * (1 - fx) + pixel(*this, x0 + 1, y0) * fx;
    const Rgb bottom = pixel(*this, x0, y0 + 1) * (1 - fx) + pixel(*this, x0 + 1, y0 + 1) * fx;
    return top * (1 - fy) + bottom * fy;
}

}  // namespace lumi::baker
