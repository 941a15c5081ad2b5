// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_shade.h"

namespace lumi
{
namespace
{

constexpr WeightReciprocals make_reciprocals()
{
    WeightReciprocals t{};
    for (uint32_t w = 2; w <= 256; ++w) t.q16[w] = static_cast<uint16_t>((65536 + w / 2) / w);
    t.q16[0] = t.q16[1] = 65535;
    return t;
}

}  // namespace

constexpr WeightReciprocals kWeightReciprocals = make_reciprocals();

}  // namespace lumi
