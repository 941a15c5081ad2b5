// SPDX-License-Identifier: MIT
// A guided field, read in place: sections of guided_format.h behind typed accessors. The caller owns the bytes and
// keeps them alive and unchanged. open_guided() checks everything that decides where bytes are read.
#pragma once

#include "lumi/field.h"
#include "lumi/guided/guided_format.h"

namespace lumi
{

// A surface of packed triangles.
struct ProxyMesh {
    const uint8_t* vertices = nullptr;
    const uint8_t* triangles = nullptr;
    uint32_t vertex_count = 0, triangle_count = 0;
    bool two_sided = false;
};

// Three 12-bit numbers.
struct Triple12 {
    uint16_t a, b, c;
};

inline Triple12 triple12(const uint8_t* block, uint32_t k)
{
    const uint8_t* p = block + (k >> 1) * 9;
    if ((k & 1) == 0) {
        return {static_cast<uint16_t>(p[0] | (p[1] & 0x0F) << 8), static_cast<uint16_t>(p[1] >> 4 | p[2] << 4),
                static_cast<uint16_t>(p[3] | (p[4] & 0x0F) << 8)};
    }
    return {static_cast<uint16_t>(p[4] >> 4 | p[5] << 4), static_cast<uint16_t>(p[6] | (p[7] & 0x0F) << 8),
            static_cast<uint16_t>(p[7] >> 4 | p[8] << 4)};
}

// Sparse voxels of the view-averaged colour.
struct MeanColours {
    const uint8_t* palette = nullptr;  // 256 × 4 with palette8
    const uint8_t* index = nullptr;    // u16 per brick of the box
    const uint8_t* bricks = nullptr;   // brick_count × 64 nodes of 2 bytes or 1
    uint32_t resolution = 0;           // 0: no mean section
    format::MeanFormat format = format::MeanFormat::rgb565;
    uint8_t first_brick[3] = {}, box[3] = {};
    uint32_t brick_count = 0;
};

// Texels by origin and grid point.
struct ChartTable {
    const uint8_t* directory = nullptr;
    const uint8_t* rows = nullptr;
    const uint8_t* texels = nullptr;
    uint32_t row_count = 0, texel_count = 0;
};

struct GuidedField {
    Lattice origins;
    uint32_t used_origins = 0;
    uint32_t chart_size = 0;  // G
    uint32_t origins_per_palette = 1;
    format::GuidedTexel texel = format::GuidedTexel::none;
    format::GuidedSurface surface = format::GuidedSurface::proxy;
    format::ColourSpace colour_space = format::ColourSpace::srgb;
    ProxyMesh proxy;
    MeanColours mean;
    ChartTable chart;
    ChartTable occlusion;              // texel_count 0: none
    const uint8_t* colours = nullptr;  // chart colours
    int16_t focus_q14[3] = {};         // each within [-1, 1]
    uint16_t focus_radius_q14 = 0;
    uint32_t centre_bits[3] = {};  // IEEE binary32 patterns: core never computes with them
    uint32_t radius_bits = 0;
};

// Checks `size` bytes and fills `out`, which stays untouched on failure. Cost: a CRC over header and table, one pass
// over the triangles, the brick index and the chart directories. verify_field() (field.h) knows guided files, too.
FieldError open_guided(const uint8_t* bytes, size_t size, GuidedField& out);

}  // namespace lumi
