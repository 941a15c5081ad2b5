// SPDX-License-Identifier: MIT
// Guided fields as a hostile file brings them: small ones of every kind, opened at an odd address, read to the last
// byte.
#pragma once

#include <algorithm>
#include <memory>

#include "guided/guided_bytes.h"
#include "lumi/guided/guided_field.h"

namespace lumi::test
{

// Bytes at an odd address in an allocation of their own, so that a sanitizer sees a read past either end.
struct OddCopy {
    explicit OddCopy(const Bytes& bytes) : memory(new uint8_t[bytes.size() + 1]), size(bytes.size())
    {
        std::copy(bytes.begin(), bytes.end(), memory.get() + 1);
    }
    const uint8_t* data() const { return memory.get() + 1; }

    std::unique_ptr<uint8_t[]> memory;
    size_t size;
};

inline FieldError open_copy(const Bytes& bytes)
{
    const OddCopy copy(bytes);
    GuidedField field;
    return open_guided(copy.data(), copy.size, field);
}

inline uint32_t u16(const uint8_t* p)
{
    return p[0] | static_cast<uint32_t>(p[1]) << 8;
}

inline uint32_t u32(const uint8_t* p)
{
    return u16(p) | u16(p + 2) << 16;
}

// Reads every byte that open_guided promises to be there, the way a renderer finds it.
inline uint32_t touch_table(const ChartTable& table, uint32_t origins, uint32_t texels_per_byte)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; table.directory != nullptr && i < origins; ++i) {
        const uint8_t* e = table.directory + i * format::chart::kEntryBytes;
        sum += u32(e + format::chart::kTexelBaseAt) <= table.texel_count ? 0 : 1u << 31;
        const uint32_t rows = u16(e + format::chart::kRowCountAt);
        for (uint32_t r = 0; r < rows; ++r) sum += u16(table.rows + 2 * (u32(e + format::chart::kRowBaseAt) + r));
    }
    for (uint32_t k = 0; k < table.texel_count; ++k) sum += table.texels[k / texels_per_byte];
    return sum;
}

inline uint32_t touch_mesh(const ProxyMesh& mesh)
{
    uint32_t sum = 0;
    for (uint32_t k = 0; k < mesh.triangle_count; ++k) {
        const Triple12 t = triple12(mesh.triangles, k);
        for (const uint32_t corner : {t.a, t.b, t.c}) sum += triple12(mesh.vertices, corner).c;
    }
    return sum;
}

inline uint32_t touch_mean(const MeanColours& mean)
{
    uint32_t sum = 0;
    const uint32_t node_bytes = mean.palette != nullptr ? 1 : 2;
    for (uint32_t k = 0; k < uint32_t{mean.box[0]} * mean.box[1] * mean.box[2]; ++k) {
        sum += mean.bricks[(u16(mean.index + 2 * k) + 1) * format::kBrickNodes * node_bytes - 1];
    }
    return sum + (mean.palette != nullptr ? mean.palette[format::kPaletteBytes - 1] : 0);
}

inline uint32_t touch(const GuidedField& field)
{
    const uint32_t groups = (field.used_origins + field.origins_per_palette - 1) / field.origins_per_palette;
    const uint32_t entries = format::chart_colours(field.texel);
    uint32_t sum = touch_mesh(field.proxy) + touch_mean(field.mean);
    for (uint32_t k = 0; field.colours != nullptr && k < groups * entries * 4; ++k) sum += field.colours[k];
    return sum + touch_table(field.chart, field.used_origins, field.texel == format::GuidedTexel::index4 ? 2 : 1) +
           touch_table(field.occlusion, field.used_origins, 1);
}

constexpr uint32_t kBlocksKind = 6;

// A small field of every kind that the format knows, 0 to kBlocksKind.
inline TestGuided small_guided(uint32_t kind)
{
    TestGuided g;
    g.texel = kind % 3 == 0   ? format::GuidedTexel::index4
              : kind % 3 == 1 ? format::GuidedTexel::index8
                              : format::GuidedTexel::none;
    g.surface = kind < 3 ? format::GuidedSurface::proxy : format::GuidedSurface::focus;
    g.used_origins = 3;
    g.origins_per_palette = 2;
    if (kind == kBlocksKind) {
        g.texel = format::GuidedTexel::vq8;
        g.surface = format::GuidedSurface::proxy;
        g.origins_per_palette = 3;
    }
    return g;
}

inline Bytes small_file(uint32_t kind)
{
    TestMean mean;
    mean.format = kind % 2 == 0 ? format::MeanFormat::rgb565 : format::MeanFormat::palette8;
    return sample_guided(small_guided(kind), tetrahedron(), mean);
}

}  // namespace lumi::test
