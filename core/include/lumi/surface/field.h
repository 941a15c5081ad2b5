// SPDX-License-Identifier: MIT
// A surface field, read in place: sections of surface/format.h. The caller owns the bytes and keeps them alive and
// unchanged. open_surface() checks everything that decides where bytes are read, so no later call can leave the buffer.
#pragma once
#pragma GCC system_header

#include "lumi/detail/aligned_words.h"
#include "lumi/field.h"
#include "lumi/surface/format.h"

namespace lumi
{

struct SurfaceField {
    const uint8_t* vertices = nullptr;      // vertex_count × kVertexBytes
    const uint8_t* patches = nullptr;       // patch_count × kPatchBytes
    const uint8_t* texels = nullptr;        // every byte that 6-bit coordinates of any patch can name is there
    const uint8_t* palette = nullptr;       // 256 × (r, g, b)
    const uint8_t* node_colours = nullptr;  // view_colours_bytes(code_bits), or null
    const uint8_t* views = nullptr;         // the view tables of vertices 0 .. viewed_count - 1
    const uint8_t* neighbours = nullptr;    // patch_count × kNeighbourBytes, or null
    uint32_t vertex_count = 0, viewed_count = 0, patch_count = 0, texel_bytes = 0;
    uint32_t longest_edge_q6 = 0;  // radii
    ColourSpace colour_space = ColourSpace::srgb;
    uint8_t code_bits = 0;         // of view tables
    uint32_t centre_bits[3] = {};  // IEEE binary32 patterns: core never computes with them
    uint32_t radius_bits = 0;
};

// Checks `size` bytes and fills `out`, which stays untouched on failure. Cost: a CRC over header and table, one pass
// over vertices and patches. verify_field() (field.h) checks the CRC of every section.
FieldError open_surface(const uint8_t* bytes, size_t size, SurfaceField& out);

}  // namespace lumi

namespace lumi::detail
{

struct VertexQ14 {
    int32_t x, y, z;
};

inline VertexQ14 surface_vertex(const SurfaceField& field, uint32_t k)
{
    const uint8_t* p = field.vertices + k * format::kVertexBytes;
    const auto number = [&](int at) {
        return static_cast<int32_t>(static_cast<int16_t>(static_cast<uint16_t>(p[at] | p[at + 1] << 8)));
    };
    return {number(0), number(2), number(4)};
}

struct SurfacePatch {
    uint32_t corner[4];  // a, b, c, d; d may be kNoVertex
    uint32_t texels, columns, rows;
};

// The three words of a patch, where a field may lie at any address.
inline SurfacePatch surface_patch(const SurfaceField& field, uint32_t k)
{
    const uint8_t* p = field.patches + k * format::kPatchBytes;
    const auto word = [&](const uint8_t* at) {
        return static_cast<uint32_t>(at[0]) | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
               static_cast<uint32_t>(at[3]) << 24;
    };
    const bool is_aligned = (reinterpret_cast<uintptr_t>(p) & 3) == 0;
    const uint32_t ab = is_aligned ? load_aligned<uint32_t>(p) : word(p);
    const uint32_t cd = is_aligned ? load_aligned<uint32_t>(p + 4) : word(p + 4);
    const uint8_t* const at = p + format::patch::kTexelsAt;
    const uint32_t place = is_aligned ? load_aligned<uint32_t>(at) : word(at);
    return {{ab & 0xFFFF, ab >> 16, cd & 0xFFFF, cd >> 16}, place & 0xFFFFF, (place >> 20) & 63, place >> 26};
}

}  // namespace lumi::detail
