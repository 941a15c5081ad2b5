// SPDX-License-Identifier: MIT
// A surface field, read in place: sections of surface/format.h. The caller owns the bytes and keeps them alive and
// unchanged. open_surface() checks everything that decides where bytes are read, so no later call can leave the buffer.
#pragma once
#pragma GCC system_header

#include "lumi/detail/aligned_words.h"
#include "lumi/field.h"
#include "lumi/fixed.h"
#include "lumi/surface/format.h"

namespace lumi
{

// A field may have these besides opaque triangles that rest, and a firmware draws them or not: a mask, the same in
// every call. Code that draws the others is not linked. `parts` are those that move, `states` lights whose weights are
// chosen; without it a field shows all of them at their full weight. `gloss` are maps of what smooth surfaces mirror.
enum class SurfaceFeatures : uint8_t {
    none = 0,
    view_tables = 1,
    see_through = 2,
    parts = 4,
    states = 8,
    gloss = 16,
    all = 31
};

constexpr SurfaceFeatures operator|(SurfaceFeatures a, SurfaceFeatures b)
{
    return static_cast<SurfaceFeatures>(static_cast<uint8_t>(a) | static_cast<uint8_t>(b));
}

constexpr bool has(SurfaceFeatures mask, SurfaceFeatures feature)
{
    return (static_cast<uint8_t>(mask) & static_cast<uint8_t>(feature)) != 0;
}

struct SurfaceField {
    const uint8_t* vertices = nullptr;      // vertex_count × kVertexBytes
    const uint8_t* patches = nullptr;       // patch_count × kPatchBytes
    const uint8_t* texels = nullptr;        // every byte that 6-bit coordinates of any patch can name is there
    const uint8_t* palette = nullptr;       // 256 × (r, g, b)
    const uint8_t* node_colours = nullptr;  // view_colours_bytes(code_bits), or null
    const uint8_t* views = nullptr;         // the view tables of vertices 0 .. viewed_count - 1
    const uint8_t* neighbours = nullptr;    // as many × kNeighbourBytes, or null
    const uint8_t* see_through = nullptr;   // the section of see-through parts, or null
    const uint8_t* parts = nullptr;         // the records of moving parts, part_count × kPartBytes, or null
    const uint8_t* sphere = nullptr;        // centre and radius: 4 × IEEE binary32, with which core never computes
    uint32_t texel_bytes = 0;
    uint16_t vertex_count = 0;
    uint16_t lit_count = 0;  // vertices 0 .. this - 1 are lit by these tables: all of them, or none (surface/states.h)
    uint16_t patch_count = 0, see_through_count = 0;  // see-through patches lie behind the opaque ones
    ColourSpace colour_space = ColourSpace::srgb;
    uint8_t code_bits = 0;        // of view tables
    uint8_t longest_edge_q6 = 0;  // radii
    uint8_t part_count = 0;       // records of parts: shadows come last
    // Last, so that what is read for every triangle and vertex lies near the beginning.
    const uint8_t* states = nullptr;  // the section of light states, or null
    uint16_t viewed_count = 0;
    uint8_t state_count = 0;
    bool has_states_of_see_through = false;  // the section has them, whether or not such patches are read
    const uint8_t* gloss = nullptr;          // the section of gloss maps, or null
};

// How a part moves, and how far: formats of surface/format.h.
struct PartMotion {
    bool slides;
    bool light_stays;  // view tables are read for the eye that does not turn with it
    Vec3q30 axis;
    Vec3q20 pivot;
    int32_t from;
    uint32_t span;
};
// A part's name as the file has it: `bytes` of UTF-8, without a zero behind them.
struct PartName {
    const char* text;
    uint32_t bytes;
};
// Counts the parts that move by themselves, not their shadows: parts have the numbers below.
uint32_t mover_count(const SurfaceField& field);
// Return them, and the first of its patches, for a part below part_count.
PartMotion part_motion(const SurfaceField& field, uint32_t part);
PartName part_name(const SurfaceField& field, uint32_t part);
uint32_t first_patch_of_part(const SurfaceField& field, uint32_t part);

// Counts gloss maps.
constexpr uint32_t gloss_count(const SurfaceField& field)
{
    return field.gloss == nullptr ? 0 : field.gloss[0];
}

}  // namespace lumi

namespace lumi::detail
{

// Opens what fields of all kinds have, and refuses what `known` does not name. The others read and check what it names,
// see-through patches first.
FieldError open_mesh(const uint8_t* bytes, size_t size, SurfaceFeatures known, SurfaceField& out);
FieldError read_see_through(const uint8_t* bytes, SurfaceField& field);
FieldError read_parts(const uint8_t* bytes, SurfaceField& field);
FieldError read_states(const uint8_t* bytes, SurfaceField& field);
FieldError read_gloss(const uint8_t* bytes, SurfaceField& field);

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

// Reads the three words of a patch. A field may lie at any address.
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

namespace lumi
{

// Checks `size` bytes and fills `out`, which stays untouched on failure. Cost: a CRC over header and table, one pass
// over vertices and patches. verify_field() (field.h) checks the CRC of every section. A field with see-through parts
// is FieldError::see_through where kFeatures does not name them, one with moving parts FieldError::parts, and one with
// gloss maps FieldError::gloss.
template <SurfaceFeatures kFeatures = SurfaceFeatures::view_tables>
FieldError open_surface(const uint8_t* bytes, size_t size, SurfaceField& out)
{
    SurfaceField field;
    FieldError error = detail::open_mesh(bytes, size, kFeatures, field);
    if constexpr (has(kFeatures, SurfaceFeatures::see_through))
        if (error == FieldError::none) error = detail::read_see_through(bytes, field);
    if constexpr (has(kFeatures, SurfaceFeatures::parts))
        if (error == FieldError::none) error = detail::read_parts(bytes, field);
    if constexpr (has(kFeatures, SurfaceFeatures::states))
        if (error == FieldError::none) error = detail::read_states(bytes, field);
    if constexpr (has(kFeatures, SurfaceFeatures::gloss))
        if (error == FieldError::none) error = detail::read_gloss(bytes, field);
    if (error == FieldError::none) out = field;
    return error;
}

}  // namespace lumi
