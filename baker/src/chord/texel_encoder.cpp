// SPDX-License-Identifier: MIT
#include "chord/texel_encoder.h"

#include "lumi/chord/texel.h"

namespace lumi::baker
{

void encode_texel(format::TexelFormat format, const Palette& palette, const Estimate& estimate, uint8_t* row,
                  uint32_t j)
{
    uint8_t* const at = row + static_cast<size_t>(j) * format::bytes_per_texel(format);
    with_texel(format, [&](auto texel) {
        if constexpr (decltype(texel)::kIndexed)
            *at = nearest_entry(palette, estimate.covered_colour());
        else if (estimate.mostly_covered())  // rows start out as zeros, which mean a miss
            texel.store(at, estimate.colour());
    });
}

}  // namespace lumi::baker
