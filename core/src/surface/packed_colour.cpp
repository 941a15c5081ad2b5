// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/packed_colour.h"

namespace lumi::detail
{
namespace
{

// A field's guard bit; the bits below it are its value.
PackedColour clamped_field(PackedColour sum, uint32_t guard, uint32_t value_bits)
{
    if ((sum & guard) == 0) return sum;
    const PackedColour others = sum & ~(guard | value_bits);
    return (sum & (guard >> 1)) != 0 ? others : others | value_bits;
}

// To the nearest whole number; v <= 255².
uint32_t root_of(uint32_t v)
{
    uint32_t root = 0;
    for (uint32_t bit = 128; bit != 0; bit >>= 1) {
        const uint32_t trial = root | bit;
        if (trial * (trial - 1) < v) root = trial;
    }
    return root;
}

}  // namespace

LUMI_HOT PackedColour mean_light_of(const PackedColour (&c)[4], PackedColour black)
{
    const Rgb8 none = unpacked(black);
    uint32_t r = 0, g = 0, b = 0;
    const auto square = [](int32_t v) { return static_cast<uint32_t>(v * v); };
    for (const PackedColour one : c) {
        const Rgb8 levels = unpacked(one);
        r += square(levels.r - none.r);
        g += square(levels.g - none.g);
        b += square(levels.b - none.b);
    }
    return packed_colour(4 * root_of(r >> 2), 4 * root_of(g >> 2), 4 * root_of(b >> 2)) + black;
}

LUMI_HOT PackedColour lumi_clamped(PackedColour sum)
{
    sum = clamped_field(sum, 0x80000000, 0x7FE00000);
    sum = clamped_field(sum, 0x00100000, 0x000FFC00);
    return clamped_field(sum, 0x00000200, 0x000001FF);
}

}  // namespace lumi::detail
