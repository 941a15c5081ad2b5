// SPDX-License-Identifier: MIT
#include "lumi/detail/surface/packed_colour.h"

namespace lumi
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

}  // namespace

LUMI_HOT PackedColour clamped(PackedColour sum)
{
    sum = clamped_field(sum, 0x80000000, 0x7FE00000);
    sum = clamped_field(sum, 0x00100000, 0x000FFC00);
    return clamped_field(sum, 0x00000200, 0x000001FF);
}

}  // namespace lumi
