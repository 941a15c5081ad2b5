// SPDX-License-Identifier: MIT
// A fixed list of frames and their CRCs: every view × renderer × texel format as RGB565, and linear ones of every pixel
// format. LUMI_EVERY_FRAME draws every combination of the four.
// One text is compiled for the host and for every board: equal lines prove equal pictures, bit by bit.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "lumi/chord/format.h"

namespace lumi::firmware
{

// This is a field file in memory.
struct FieldBytes {
    const uint8_t* bytes;
    size_t size;
};

using WriteText = void (*)(const char* zero_terminated);

// The list has four fields in the order of TexelFormat, then two surface fields.
inline constexpr uint32_t kListedFields = detail::format::kTexelFormats + 2;

// Draws the list, stripe by stripe. Writes one line a frame of a chord field, "view renderer texel pixel crc32"; the
// CRC runs over the frame drawn over a constant colour, then over the frame drawn once more over that. Frames of a
// surface field: "view surface mode pixel crc32". Stops with a line "error: ..." and returns false if a field does not
// open.
bool write_frame_crcs(const FieldBytes (&fields)[kListedFields], WriteText write);

// The surface fields' part: of up to 128 vertices and patches, in every mode and as every kind of pixel, which are the
// same however a frame is cut into rectangles.
bool write_surface_crcs(const FieldBytes& file, const char* name, WriteText write);

}  // namespace lumi::firmware
