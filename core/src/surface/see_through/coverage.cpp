// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/see_through_samples.h"

namespace lumi::detail
{
namespace
{

uint8_t coverage_of_four(const SampleRows& rows, int32_t x, int32_t y)
{
    uint32_t sum = 0;
    for (int32_t row = 2 * y; row < 2 * y + 2; ++row)
        for (int32_t column = 2 * x; column < 2 * x + 2; ++column) sum += coverage_of(rows.depths(row)[column]);
    return static_cast<uint8_t>((sum + 2) >> 2);
}

uint8_t coverage_of_one(const SampleRows& rows, int32_t x, int32_t y)
{
    const MixedPair pair = mixed_pair(rows, x, y);
    const uint32_t sum = pair.own_coverage() * (32 - pair.share) + pair.other_coverage() * pair.share;
    return static_cast<uint8_t>((sum + 16) >> 5);
}

}  // namespace

MixedPair mixed_pair(const SampleRows& rows, int32_t x, int32_t y)
{
    const uint16_t* const own = rows.depths(y) + x;
    if (!is_marked(rows, x, y)) return {own, own, 0, false};
    const Mark mark(rows, x, y);
    return {mark.own, mark.other, mark.share, true};
}

void unmark_glass(const SampleRows& rows)
{
    for (int32_t y = 0; y < rows.height; ++y)
        for (int32_t x = 0; x < rows.width; ++x)
            if (is_marked(rows, x, y) && is_glass_alone(*Mark(rows, x, y).other))
                rows.depths(y)[x] = static_cast<uint16_t>(rows.depths(y)[x] & ~mark_bits(kMostShare, PixelSide::right));
}

void store_see_through_coverage(const StripeSamples& s, int32_t y)
{
    uint8_t* pixel = pixel_of<PixelA8>(s.stripe, s.part.left_px, y);
    for (int32_t x = s.begin(); x < s.end(); ++x)
        *pixel++ =
            s.frame.samples_log2 == 0 ? coverage_of_one(s.rows, x, s.row(y)) : coverage_of_four(s.rows, x, s.row(y));
}

}  // namespace lumi::detail
