// SPDX-License-Identifier: MIT
#include "math/reciprocal.h"

namespace lumi::detail
{
namespace
{

constexpr ReciprocalTable make_table()
{
    ReciprocalTable t{};
    // 2^29 / (256 (k + 1/2)) = 2^22 / (2 k + 1), rounded.
    for (uint32_t k = 128; k < 512; ++k) {
        const uint32_t odd = 2 * k + 1;
        t.q29[k - 128] = static_cast<uint16_t>(((uint32_t{1} << 22) + odd / 2) / odd);
    }
    return t;
}

}  // namespace

constexpr ReciprocalTable kReciprocals = make_table();

}  // namespace lumi::detail
