// SPDX-License-Identifier: MIT
// A field L(i,j), read in place: radiance of the ray from origin point i to direction point j (LumiPath, section 2.1).
//
// The caller owns the bytes (usually memory-mapped flash) and keeps them alive and unchanged while the Field is used.
// open_field() checks everything that decides where bytes are read, so no later call can leave the buffer.
#pragma once
#pragma GCC system_header

#include "lumi/chord/format.h"
#include "lumi/detail/lattice.h"
#include "lumi/field.h"

namespace lumi
{

struct Field {
    detail::Lattice origins;
    detail::Lattice directions;
    uint32_t used_origins = 0;
    uint32_t row_stride_bytes = 0;
    const uint8_t* texels = nullptr;   // used_origins rows of row_stride_bytes
    const uint8_t* palette = nullptr;  // kPaletteBytes, or null
    TexelFormat texel_format = TexelFormat::rgb888;
    ColourSpace colour_space = ColourSpace::srgb;
    uint32_t centre_bits[3] = {};  // IEEE binary32 patterns: core never computes with them
    uint32_t radius_bits = 0;

    // Returns row i, or null for an origin outside the cap.
    const uint8_t* row(uint32_t i) const
    {
        return i < used_origins ? texels + static_cast<size_t>(i) * row_stride_bytes : nullptr;
    }
};

// Checks `size` bytes and fills `out`; `out` stays untouched on failure. Cost: a CRC over the header and the table.
FieldError open_field(const uint8_t* bytes, size_t size, Field& out);

}  // namespace lumi
