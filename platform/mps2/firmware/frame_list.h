// SPDX-License-Identifier: MIT
// A fixed list of frames and their CRCs: every view × renderer × texel format as RGB565, and linear ones of every pixel
// format. LUMI_EVERY_FRAME draws every combination of the four.
// The same text is compiled for the host and for every board: equal lines prove equal pictures, bit by bit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lumi/field_format.h"

namespace lumi::firmware
{

// A field file in memory.
struct FieldBytes {
    const uint8_t* bytes;
    size_t size;
};

using WriteText = void (*)(const char* zero_terminated);

// Draws the list, stripe by stripe, with fields[f] for texel format f. Writes one line a frame,
// "view renderer texel pixel crc32"; the CRC runs over the frame drawn over a constant colour, then over the
// frame drawn once more over that. Stops with a line "error: ..." and returns false if a field does not open.
bool write_frame_crcs(const FieldBytes (&fields)[format::kTexelFormats], WriteText write);

// The same for a guided field of 4-bit texels, RGB565 voxels and a proxy of up to 64 vertices and triangles, drawn once
// over a constant colour; "view guided picture rgb888 crc32". The file's address is divisible by 4.
bool write_guided_crcs(const FieldBytes& file, WriteText write);

}  // namespace lumi::firmware
