// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/see_through.h"

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

uint8_t coverage_of_four(const Target& target, int32_t x, int32_t y)
{
    uint32_t sum = 0;
    for (int32_t row = 2 * y; row < 2 * y + 2; ++row)
        for (int32_t column = 2 * x; column < 2 * x + 2; ++column) sum += coverage_of(target.depths(row)[column]);
    return static_cast<uint8_t>((sum + 2) >> 2);
}

uint8_t coverage_of_one(const Target& target, int32_t x, int32_t y)
{
    const MixedPair pair = mixed_pair(target, x, y);
    const uint32_t sum = pair.own_coverage() * (32 - pair.share) + pair.other_coverage() * pair.share;
    return static_cast<uint8_t>((sum + 16) >> 5);
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

MixedPair mixed_pair(const Target& target, int32_t x, int32_t y)
{
    const uint16_t* const own = target.depths(y) + x;
    if (!is_marked(target, x, y)) return {own, own, 0, false};
    const Mark mark(target, x, y);
    return {mark.own, mark.other, mark.share, true};
}

void unmark_glass(const Target& target)
{
    for (int32_t y = 0; y < target.height; ++y)
        for (int32_t x = 0; x < target.width; ++x)
            if (is_marked(target, x, y) && is_glass_alone(*Mark(target, x, y).other))
                target.depths(y)[x] =
                    static_cast<uint16_t>(target.depths(y)[x] & ~mark_bits(kMostShare, PixelSide::right));
}

void store_see_through_coverage(const StripeSamples& s, int32_t y)
{
    const uint32_t log2 = s.frame.samples_log2;
    uint8_t* pixel = pixel_of<PixelA8>(s.covered, s.covered.x_px, y);
    const int32_t begin = s.covered.x_px - (s.target.x >> log2), row = y - (s.target.y >> log2);
    for (int32_t x = begin; x < begin + s.covered.width_px; ++x)
        *pixel++ = log2 == 0 ? coverage_of_one(s.target, x, row) : coverage_of_four(s.target, x, row);
}

}  // namespace lumi::detail
