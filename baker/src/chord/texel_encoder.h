// SPDX-License-Identifier: MIT
// Turns estimates into the texels of a row.
#pragma once

#include <cstdint>

#include "image/palette.h"
#include "lumi/field_format.h"
#include "trace/estimate.h"

namespace lumi::baker
{

// Writes texel j of a row. `palette` is only read for palette8.
void encode_texel(format::TexelFormat format, const Palette& palette, const Estimate& estimate, uint8_t* row,
                  uint32_t j);

}  // namespace lumi::baker
