// SPDX-License-Identifier: MIT
#include "chord/texel_encoder.h"

#include "lumi/texel.h"

namespace lumi::baker
{

void encode_texel(format::TexelFormat format, const Palette& palette, const Estimate& estimate, uint8_t* row,
                  uint32_t j)
{
    const size_t at = static_cast<size_t>(j) * format::bytes_per_texel(format);
    if (format == format::TexelFormat::palette8) {
        row[at] = nearest_entry(palette, estimate.covered_colour());
        return;
    }
    if (!estimate.mostly_covered()) {
        return;  // rows start out as zeros, which mean a miss
    }
    const Rgb8 colour = estimate.colour();
    if (format == format::TexelFormat::rgb888) {
        const Rgb8 c = TexelRgb888::encode(colour);
        row[at] = c.r;
        row[at + 1] = c.g;
        row[at + 2] = c.b;
    } else if (format == format::TexelFormat::rgb565) {
        const uint16_t v = TexelRgb565::encode(colour);
        row[at] = static_cast<uint8_t>(v & 0xFF);
        row[at + 1] = static_cast<uint8_t>(v >> 8);
    } else {
        row[at] = TexelLuma8::encode(colour);
    }
}

}  // namespace lumi::baker
