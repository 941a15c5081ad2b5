// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/resolve.h"

namespace lumi::detail
{
namespace
{

uint8_t share_of_four(const Target& target, int32_t x, int32_t y)
{
    uint32_t count = 0;
    for (int32_t row = 2 * y; row < 2 * y + 2; ++row)
        for (int32_t column = 2 * x; column < 2 * x + 2; ++column)
            count += target.depths(row)[column] != kEmptyDepth ? 1u : 0u;
    return static_cast<uint8_t>((count * 255 + 2) >> 2);
}

uint8_t share_of_one(const Target& target, int32_t x, int32_t y)
{
    if (is_marked(target, x, y)) return static_cast<uint8_t>((Mark(target, x, y).covered() * 255 + 16) >> 5);
    return target.depths(y)[x] != kEmptyDepth ? 255 : 0;
}

}  // namespace

void store_coverage(const StripeSamples& s, int32_t y)
{
    const uint32_t log2 = s.frame.samples_log2;
    uint8_t* pixel = pixel_of<PixelA8>(s.covered, s.covered.x_px, y);
    const int32_t begin = s.covered.x_px - (s.target.x >> log2), row = y - (s.target.y >> log2);
    for (int32_t x = begin; x < begin + s.covered.width_px; ++x)
        *pixel++ = log2 == 0 ? share_of_one(s.target, x, row) : share_of_four(s.target, x, row);
}

}  // namespace lumi::detail
