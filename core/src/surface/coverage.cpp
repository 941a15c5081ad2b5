// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/resolve.h"

namespace lumi::detail
{
namespace
{

uint8_t share_of_four(const SampleRows& rows, int32_t x, int32_t y)
{
    uint32_t count = 0;
    for (int32_t row = 2 * y; row < 2 * y + 2; ++row)
        for (int32_t column = 2 * x; column < 2 * x + 2; ++column)
            count += rows.depths(row)[column] != kEmptyDepth ? 1u : 0u;
    return static_cast<uint8_t>((count * 255 + 2) >> 2);
}

uint8_t share_of_one(const SampleRows& rows, int32_t x, int32_t y)
{
    if (is_marked(rows, x, y)) return static_cast<uint8_t>((Mark(rows, x, y).covered() * 255 + 16) >> 5);
    return rows.depths(y)[x] != kEmptyDepth ? 255 : 0;
}

}  // namespace

void store_coverage(const StripeSamples& s, int32_t y)
{
    uint8_t* pixel = pixel_of<PixelA8>(s.stripe, s.part.left_px, y);
    for (int32_t x = s.begin(); x < s.end(); ++x)
        *pixel++ = s.frame.samples_log2 == 0 ? share_of_one(s.rows, x, s.row(y)) : share_of_four(s.rows, x, s.row(y));
}

}  // namespace lumi::detail
