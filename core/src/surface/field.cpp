// SPDX-License-Identifier: MIT
#include "lumi/surface/field.h"
#include "field/sections.h"

namespace lumi
{
namespace
{

using namespace detail;
using namespace detail::format;
using namespace detail::container;

constexpr int32_t kOneQ14 = 1 << 14;

// Those from the eighth on are known where features name them.
struct SurfaceSections {
    uint32_t types[10] = {kSurfaceSection, kVertexSection, kPatchSection,    kColourSection,
                          kPaletteRgb,     kViewSection,   kNeighbourSection};
    uint32_t count = 7;

    explicit SurfaceSections(SurfaceFeatures features)
    {
        add(features, SurfaceFeatures::see_through, kSeeThroughSection);
        add(features, SurfaceFeatures::parts, kPartsSection);
        add(features, SurfaceFeatures::gloss, kGlossSection);
    }
    KnownTypes known() const { return {types, count}; }

private:
    void add(SurfaceFeatures features, SurfaceFeatures one, uint32_t type)
    {
        if (has(features, one)) types[count++] = type;
    }
};

FieldError read_counts(const uint8_t* b, SurfaceField& out)
{
    const auto count_at = [&](uint32_t at) { return static_cast<uint16_t>(load_u16(b + at)); };
    out.vertex_count = count_at(surface::kVerticesAt);
    out.lit_count = out.viewed_count = count_at(surface::kViewedAt);
    out.patch_count = count_at(surface::kPatchesAt);
    out.texel_bytes = load_u32(b + surface::kTexelsAt);
    out.longest_edge_q6 = b[surface::kLongestEdgeAt];
    out.code_bits = b[surface::kCodeBitsAt];
    const bool counts_fit = out.vertex_count >= 3 && out.vertex_count <= kMaxSurfaceVertices &&
                            out.viewed_count <= out.vertex_count && out.patch_count >= 1 &&
                            out.patch_count <= kMaxPatches && out.texel_bytes >= 1 &&
                            out.texel_bytes <= kMaxSurfaceTexels;
    const bool edge_fits = out.longest_edge_q6 >= 1 && out.longest_edge_q6 <= 128;
    return counts_fit && edge_fits ? FieldError::none : FieldError::bad_surface;
}

FieldError read_surface(const uint8_t* b, SurfaceField& out)
{
    if (b[surface::kReservedAt] != 0) return FieldError::bad_surface;
    if (b[surface::kColourSpaceAt] >= kColourSpaces) return FieldError::bad_colour_space;
    out.colour_space = static_cast<ColourSpace>(b[surface::kColourSpaceAt]);
    BoundsBits bounds;
    if (!read_bounds(b + surface::kCentreAt, b + surface::kRadiusAt, bounds)) return FieldError::bad_bounds;
    out.sphere = b + surface::kCentreAt;
    return read_counts(b, out);
}

// Sets `at` where the section lies, which has to be `size` bytes long.
bool find_bytes(const uint8_t* bytes, uint32_t type, uint32_t size, const uint8_t*& at)
{
    Section section{};
    if (!find_section(bytes, type, section) || section.size != size) return false;
    at = bytes + section.offset;
    return true;
}

FieldError read_views(const uint8_t* bytes, SurfaceField& out)
{
    const bool has_tables = out.viewed_count != 0;
    if (has_section(bytes, kViewSection) != has_tables || (out.code_bits != 0) != has_tables)
        return FieldError::bad_views;
    if (!has_tables) return FieldError::none;
    if (out.code_bits > kMaxCodeBits) return FieldError::bad_views;
    const uint32_t colours = view_colours_bytes(out.code_bits);
    const uint32_t size = colours + out.viewed_count * view_bytes(out.code_bits);
    if (!find_bytes(bytes, kViewSection, size, out.node_colours)) return FieldError::bad_views;
    out.views = out.node_colours + colours;
    return FieldError::none;
}

FieldError read_sections(const uint8_t* bytes, SurfaceField& out)
{
    if (!find_bytes(bytes, kVertexSection, out.vertex_count * kVertexBytes, out.vertices))
        return FieldError::bad_vertices;
    if (!find_bytes(bytes, kPatchSection, out.patch_count * kPatchBytes, out.patches)) return FieldError::bad_patches;
    if (!find_bytes(bytes, kColourSection, out.texel_bytes, out.texels)) return FieldError::bad_texel_size;
    if (!find_bytes(bytes, kPaletteRgb, 3 * kPaletteEntries, out.palette)) return FieldError::bad_palette;
    if (has_section(bytes, kNeighbourSection) &&
        !find_bytes(bytes, kNeighbourSection, out.patch_count * kNeighbourBytes, out.neighbours))
        return FieldError::bad_neighbours;
    return read_views(bytes, out);
}

bool lies_in_sphere(const VertexQ14& v)
{
    const auto fits = [](int32_t c) { return -kOneQ14 <= c && c <= kOneQ14; };
    return fits(v.x) && fits(v.y) && fits(v.z) && v.x * v.x + v.y * v.y + v.z * v.z <= (kOneQ14 + 4) * (kOneQ14 + 4);
}

bool fits(const SurfacePatch& patch, const SurfaceField& field)
{
    const uint32_t* corner = patch.corner;
    const bool corners_fit = corner[0] < field.vertex_count && corner[1] < field.vertex_count &&
                             corner[2] < field.vertex_count &&
                             (corner[3] < field.vertex_count || corner[3] == kNoVertex);
    return corners_fit && patch.columns >= 1 && patch.rows >= 1 &&
           patch.texels + patch_reach(patch.columns) <= field.texel_bytes;
}

// Whether there are neighbours for no triangle but those of the field's patches.
bool has_fitting_neighbours(const SurfaceField& field)
{
    if (field.neighbours == nullptr) return true;
    for (uint32_t k = 0; k < 4 * field.patch_count; ++k) {
        const uint32_t triangle = load_u16(field.neighbours + 2 * k) & kNeighbourMask;
        if (triangle >= 2 * field.patch_count && triangle != kNoNeighbour) return false;
    }
    return true;
}

FieldError check_mesh(const SurfaceField& field)
{
    for (uint32_t k = 0; k < field.vertex_count; ++k)
        if (!lies_in_sphere(surface_vertex(field, k))) return FieldError::bad_vertices;
    for (uint32_t k = 0; k < field.patch_count; ++k)
        if (!fits(surface_patch(field, k), field)) return FieldError::bad_patches;
    return has_fitting_neighbours(field) ? FieldError::none : FieldError::bad_neighbours;
}

// Names what a file has that its reader does not know.
FieldError unknown_feature(const uint8_t* bytes, KnownTypes known)
{
    const auto is_missing = [&](uint32_t type) { return !known.has(type) && has_section(bytes, type); };
    if (is_missing(kSeeThroughSection)) return FieldError::see_through;
    if (is_missing(kPartsSection)) return FieldError::parts;
    return is_missing(kGlossSection) ? FieldError::gloss : FieldError::unknown_required;
}

FieldError check_file(const uint8_t* bytes, size_t size, KnownTypes known)
{
    if (const FieldError error = check_table(bytes, size); error != FieldError::none) return error;
    if (has_section(bytes, kGuidedSection)) return FieldError::guided_field;
    if (has_section(bytes, kLayoutSection)) return FieldError::chord_field;
    const FieldError error = check_sections(bytes, known);
    return error == FieldError::unknown_required ? unknown_feature(bytes, known) : error;
}

}  // namespace

FieldError detail::open_mesh(const uint8_t* bytes, size_t size, SurfaceFeatures known, SurfaceField& out)
{
    const SurfaceSections sections(known);
    if (const FieldError error = check_file(bytes, size, sections.known()); error != FieldError::none) return error;
    Section header{};
    if (!find_section(bytes, kSurfaceSection, header)) return FieldError::missing_surface;
    if (header.size != kSurfaceBytes) return FieldError::bad_surface;
    if (const FieldError error = read_surface(bytes + header.offset, out); error != FieldError::none) return error;
    if (const FieldError error = read_sections(bytes, out); error != FieldError::none) return error;
    const uint32_t shadows = load_u16(bytes + header.offset + surface::kShadowsAt);
    if (shadows >= out.patch_count || (shadows != 0 && !has_section(bytes, kSeeThroughSection)))
        return FieldError::bad_surface;
    if (!has(known, SurfaceFeatures::see_through)) out.patch_count = static_cast<uint16_t>(out.patch_count - shadows);
    return check_mesh(out);
}

FieldError detail::read_see_through(const uint8_t* bytes, SurfaceField& field)
{
    Section section{};
    if (!find_section(bytes, kSeeThroughSection, section)) return FieldError::none;
    if (section.size != kSeeThroughBytes) return FieldError::bad_see_through;
    const uint8_t* const at = bytes + section.offset;
    const uint32_t first = load_u16(at + see_through::kFirstAt), order = load_u16(at + see_through::kOrderAt);
    if (order >= kDrawingOrders || first >= field.patch_count) return FieldError::bad_see_through;
    field.see_through = at;
    field.see_through_count = static_cast<uint16_t>(field.patch_count - first);
    field.patch_count = static_cast<uint16_t>(first);
    return has_fitting_neighbours(field) ? FieldError::none : FieldError::bad_neighbours;
}

}  // namespace lumi
