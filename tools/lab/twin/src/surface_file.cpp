// SPDX-License-Identifier: MIT
#include "surface_file.h"

#include "lumi/surface/format.h"

namespace lumi::twin
{
namespace
{

uint32_t u16(const uint8_t* p)
{
    return p[0] | uint32_t{p[1]} << 8;
}
uint32_t u32(const uint8_t* p)
{
    return u16(p) | u16(p + 2) << 16;
}
double s8(uint8_t v)
{
    return static_cast<int8_t>(v);
}

// The bytes of a section, or null.
const uint8_t* section(const uint8_t* file, uint32_t type)
{
    const uint32_t count = u16(file + detail::format::header::kSectionCountAt);
    for (uint32_t k = 0; k < count; ++k) {
        const uint8_t* entry = file + detail::format::kHeaderBytes + k * detail::format::kEntryBytes;
        if (u32(entry + detail::format::entry::kTypeAt) == type)
            return file + u32(entry + detail::format::entry::kOffsetAt);
    }
    return nullptr;
}

std::vector<Vec3> positions_in(const uint8_t* bytes, uint32_t count)
{
    constexpr double kOne = 16384;  // Q14
    std::vector<Vec3> positions;
    for (uint32_t v = 0; v < count; ++v, bytes += detail::format::kVertexBytes) {
        const auto axis = [&](uint32_t k) { return static_cast<int16_t>(u16(bytes + 2 * k)) / kOne; };
        positions.push_back({axis(0), axis(1), axis(2)});
    }
    return positions;
}

std::vector<SurfaceTriangle> triangles_in(const uint8_t* bytes, uint32_t patches)
{
    std::vector<SurfaceTriangle> triangles;
    for (uint32_t p = 0; p < patches; ++p, bytes += detail::format::kPatchBytes) {
        const auto corner = [&](uint32_t k) { return u16(bytes + detail::format::patch::kCornersAt + 2 * k); };
        const uint32_t texels = u32(bytes + detail::format::patch::kTexelsAt);
        const uint32_t begin = texels & 0xFFFFF, n = texels >> 20 & 63, m = texels >> 26;
        triangles.push_back({{corner(0), corner(1), corner(2)}, begin, n, m, false});
        if (corner(3) != detail::format::kNoVertex)
            triangles.push_back({{corner(3), corner(2), corner(1)}, begin, n, m, true});
    }
    return triangles;
}

// Codes one after the other, bit by bit.
SurfaceView view_in(const uint8_t* record, const uint8_t* colours, uint32_t bits)
{
    SurfaceView view = {{}, {}};
    const uint8_t *turn = record + detail::format::view_turn_at(bits), *gain = turn + detail::format::kTurnBytes;
    for (uint32_t k = 0; k < 3; ++k) view.turn[k] = static_cast<int8_t>(turn[k]);
    for (uint32_t node = 0; node < detail::format::kViewNodes; ++node) {
        uint32_t code = 0;
        for (uint32_t bit = 0; bit < bits; ++bit) {
            const uint32_t at = node * bits + bit;
            code |= (record[at / 8] >> at % 8 & 1u) << bit;
        }
        const uint8_t* c = colours + ((node << bits) + code) * detail::format::kNodeColourBytes;
        view.nodes.push_back({gain[0] / 64.0 * s8(c[0]), gain[1] / 64.0 * s8(c[1]), gain[2] / 64.0 * s8(c[2])});
    }
    return view;
}

}  // namespace

SurfaceFile::SurfaceFile(const uint8_t* file)
{
    namespace at = detail::format::surface;
    const uint8_t* head = section(file, detail::format::kSurfaceSection);
    positions = positions_in(section(file, detail::format::kVertexSection), u16(head + at::kVerticesAt));
    triangles = triangles_in(section(file, detail::format::kPatchSection), u16(head + at::kPatchesAt));
    const uint8_t *indices = section(file, detail::format::kColourSection),
                  *palette = section(file, detail::format::kPaletteRgb);
    for (uint32_t k = 0; k < u32(head + at::kTexelsAt); ++k) {
        const uint8_t* c = palette + 3 * indices[k];
        texels.push_back({static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])});
    }
    const uint8_t* tables = section(file, detail::format::kViewSection);
    const uint32_t bits = head[at::kCodeBitsAt], colours = detail::format::view_colours_bytes(bits);
    for (uint32_t v = 0; v < u16(head + at::kViewedAt); ++v)
        views.push_back(view_in(tables + colours + v * detail::format::view_bytes(bits), tables, bits));
}

}  // namespace lumi::twin
