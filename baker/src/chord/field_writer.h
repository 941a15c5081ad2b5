// SPDX-License-Identifier: MIT
// Lays out and writes field files, version 1 (lumi/field_format.h).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "image/palette.h"
#include "lumi/chord/format.h"
#include "store/posix_file.h"

namespace lumi::baker
{

struct FieldLayout {
    uint32_t origins, directions, used_origins;
    TexelFormat texel;
    std::array<float, 3> centre;  // scene units, scene axes
    float radius;

    uint32_t row_stride() const { return detail::format::padded_row_stride(directions, texel); }
    uint64_t texel_bytes() const { return uint64_t{row_stride()} * used_origins; }
};

// Length of the whole file; may exceed what the format's 32-bit offsets can hold.
uint64_t file_bytes(const FieldLayout& layout);

// Fills in row i, which has layout.row_stride() bytes, and may throw.
using RowSource = std::function<void(uint32_t i, std::vector<uint8_t>& row)>;

// Asks for each row once, in order. `palette` is written for palette8 only. Throws BakeError. Memory: one row.
void write_field(const FieldLayout& layout, const RowSource& texels, const Palette& palette, NewFile& out);

}  // namespace lumi::baker
