// SPDX-License-Identifier: MIT
#include "lumi/guided/guided_field.h"

#include "field/sections.h"

namespace lumi
{
namespace
{

using namespace format;
using namespace container;

constexpr uint32_t kGuidedTypes[] = {kGuidedSection, kProxySection, kMeanSection,
                                     kChartSection,  kChartColours, kOcclusionSection};

constexpr uint32_t kOneQ14 = uint32_t{1} << 14;

constexpr uint32_t padded4(uint32_t bytes)
{
    return (bytes + 3) / 4 * 4;
}

int32_t load_s16(const uint8_t* p)
{
    return static_cast<int16_t>(load_u16(p));
}

FieldError read_origins(const uint8_t* b, GuidedField& out)
{
    const uint32_t origins = load_u32(b + guided::kOriginsAt);
    out.used_origins = load_u32(b + guided::kUsedOriginsAt);
    if (origins < kMinGuidedOrigins || origins > kMaxGuidedOrigins || out.used_origins == 0 ||
        out.used_origins > origins) {
        return FieldError::bad_lattice_size;
    }
    out.origins = Lattice(origins);
    return FieldError::none;
}

FieldError read_focus(const uint8_t* b, GuidedField& out)
{
    uint32_t anything = out.focus_radius_q14 = static_cast<uint16_t>(load_u16(b + guided::kFocusRadiusAt));
    if (out.focus_radius_q14 > kOneQ14) return FieldError::bad_focus;
    for (uint32_t k = 0; k < 3; ++k) {
        const int32_t c = load_s16(b + guided::kFocusAt + 2 * k);
        if (c > static_cast<int32_t>(kOneQ14) || c < -static_cast<int32_t>(kOneQ14)) return FieldError::bad_focus;
        out.focus_q14[k] = static_cast<int16_t>(c);
        anything |= static_cast<uint32_t>(c);
    }
    return out.surface == GuidedSurface::proxy && anything != 0 ? FieldError::bad_focus : FieldError::none;
}

FieldError read_guided(const uint8_t* b, GuidedField& out)
{
    if (b[guided::kReservedAt] != 0 || load_u32(b + guided::kReserved2At) != 0 ||
        b[guided::kSurfaceAt] >= kGuidedSurfaces) {
        return FieldError::bad_guided;
    }
    if (b[guided::kTexelAt] >= kGuidedTexels) return FieldError::bad_texel_format;
    if (b[guided::kColourSpaceAt] >= kColourSpaces) return FieldError::bad_colour_space;
    out.texel = static_cast<GuidedTexel>(b[guided::kTexelAt]);
    out.surface = static_cast<GuidedSurface>(b[guided::kSurfaceAt]);
    out.colour_space = static_cast<ColourSpace>(b[guided::kColourSpaceAt]);
    out.chart_size = load_u16(b + guided::kChartSizeAt);
    if (out.chart_size < kMinChart || out.chart_size > kMaxChart) return FieldError::bad_chart_size;
    out.origins_per_palette = load_u16(b + guided::kOriginsPerPaletteAt);
    if (out.origins_per_palette == 0) return FieldError::bad_guided;
    BoundsBits bounds;
    if (!read_bounds(b + guided::kCentreAt, b + guided::kRadiusAt, bounds)) return FieldError::bad_bounds;
    for (uint32_t k = 0; k < 3; ++k) out.centre_bits[k] = bounds.centre[k];
    out.radius_bits = bounds.radius;
    if (const FieldError error = read_origins(b, out); error != FieldError::none) return error;
    return read_focus(b, out);
}

bool is_inside(const Triple12& t, uint32_t count)
{
    return t.a < count && t.b < count && t.c < count;
}

FieldError read_proxy(const uint8_t* b, uint32_t size, GuidedField& out)
{
    if (size < proxy::kVertexBlockAt) return FieldError::bad_proxy;
    ProxyMesh& mesh = out.proxy;
    mesh.vertex_count = load_u16(b + proxy::kVerticesAt);
    mesh.triangle_count = load_u16(b + proxy::kTrianglesAt);
    const uint32_t flags = load_u32(b + proxy::kFlagsAt);
    const uint32_t triangles_at = proxy_triangles_at(mesh.vertex_count);
    if (mesh.vertex_count > kMaxProxyVertices || mesh.triangle_count > kMaxProxyTriangles ||
        (flags & ~kTwoSided) != 0 || size != triangles_at + triples_bytes(mesh.triangle_count)) {
        return FieldError::bad_proxy;
    }
    mesh.two_sided = flags != 0;
    mesh.vertices = b + proxy::kVertexBlockAt;
    mesh.triangles = b + triangles_at;
    for (uint32_t k = 0; k < mesh.triangle_count; ++k) {
        if (!is_inside(triple12(mesh.triangles, k), mesh.vertex_count)) return FieldError::bad_proxy_index;
    }
    return FieldError::none;
}

// Reads the box; its number of bricks, or 0 if a side is 0 or ends beyond the last brick that a resolution can have.
uint32_t read_box(const uint8_t* b, MeanColours& mean)
{
    constexpr uint32_t kMaxSide = 64;
    uint32_t bricks = 1;
    for (uint32_t k = 0; k < 3; ++k) {
        mean.first_brick[k] = b[mean::kFirstBrickAt + k];
        mean.box[k] = b[mean::kBoxAt + k];
        bricks = mean.first_brick[k] + uint32_t{mean.box[k]} > kMaxSide ? 0 : bricks * mean.box[k];
    }
    return bricks;
}

FieldError read_mean(const uint8_t* b, uint32_t size, GuidedField& out)
{
    if (size < mean::kContentAt) return FieldError::bad_mean;
    MeanColours& mean = out.mean;
    mean.resolution = load_u16(b + mean::kResolutionAt);
    mean.brick_count = load_u16(b + mean::kBricksAt);
    const uint32_t entries = read_box(b, mean);
    if (mean.resolution < kMinMean || mean.resolution > kMaxMean || b[mean::kFormatAt] >= kMeanFormats ||
        b[mean::kReservedAt] != 0 || b[mean::kReserved2At] != 0 || b[mean::kReserved3At] != 0 ||
        load_u16(b + mean::kReserved4At) != 0 || mean.brick_count == 0 || entries == 0) {
        return FieldError::bad_mean;
    }
    mean.format = static_cast<MeanFormat>(b[mean::kFormatAt]);
    const bool indexed = mean.format == MeanFormat::palette8;
    const uint32_t index_at = mean::kContentAt + (indexed ? kPaletteBytes : 0);
    const uint32_t bricks_at = index_at + padded4(2 * entries);
    if (size != bricks_at + mean.brick_count * kBrickNodes * (indexed ? 1 : 2)) return FieldError::bad_mean;
    mean.palette = indexed ? b + mean::kContentAt : nullptr;
    mean.index = b + index_at;
    mean.bricks = b + bricks_at;
    for (uint32_t k = 0; k < entries; ++k) {
        if (load_u16(mean.index + 2 * k) >= mean.brick_count) return FieldError::bad_mean_brick;
    }
    return FieldError::none;
}

bool is_inside(const uint8_t* entry, const ChartTable& table)
{
    const uint32_t row_base = load_u32(entry + chart::kRowBaseAt);
    return load_u32(entry + chart::kTexelBaseAt) <= table.texel_count && row_base <= table.row_count &&
           load_u16(entry + chart::kRowCountAt) <= table.row_count - row_base;
}

// False unless the table fills its section exactly and every origin's rows lie inside. 2^31 texels at most, so that a
// texel's number cannot wrap.
bool read_table(const uint8_t* b, uint32_t size, uint32_t origins, uint32_t texels_per_byte, ChartTable& out)
{
    if (size < chart::kDirectoryAt) return false;
    out.row_count = load_u32(b + chart::kRowsAt);
    out.texel_count = load_u32(b + chart::kTexelsAt);
    constexpr uint32_t kMaxCount = uint32_t{1} << 31;
    if (out.row_count > kMaxCount || out.texel_count > kMaxCount) return false;
    const uint64_t rows_at = uint64_t{chart::kDirectoryAt} + origins * chart::kEntryBytes;
    const uint64_t texels_at = rows_at + (uint64_t{2} * out.row_count + 3) / 4 * 4;
    if (size != texels_at + (out.texel_count + texels_per_byte - 1) / texels_per_byte) return false;
    out.directory = b + chart::kDirectoryAt;
    out.rows = b + rows_at;
    out.texels = b + texels_at;
    for (uint32_t i = 0; i < origins; ++i) {
        if (!is_inside(out.directory + i * chart::kEntryBytes, out)) return false;
    }
    return true;
}

FieldError read_chart(const uint8_t* b, uint32_t size, GuidedField& out)
{
    const uint32_t texels_per_byte = out.texel == GuidedTexel::index4 ? 2 : 1;
    return read_table(b, size, out.used_origins, texels_per_byte, out.chart) ? FieldError::none : FieldError::bad_chart;
}

FieldError read_colours(const uint8_t* b, uint32_t size, GuidedField& out)
{
    const uint32_t groups = (out.used_origins + out.origins_per_palette - 1) / out.origins_per_palette;
    const uint32_t group_bytes = kChartColourBytes * chart_colours(out.texel);
    if (size != groups * group_bytes) return FieldError::bad_chart_colours;
    for (uint32_t k = 0; k < groups; ++k) {
        if (load_u32(b + k * group_bytes) != 0) return FieldError::bad_chart_colours;
    }
    out.colours = b;
    return FieldError::none;
}

FieldError read_occlusion(const uint8_t* b, uint32_t size, GuidedField& out)
{
    return read_table(b, size, out.used_origins, 1, out.occlusion) ? FieldError::none : FieldError::bad_occlusion;
}

// What the guided section says of another section.
enum class Need : uint8_t { none, optional, required };

template <FieldError (*kRead)(const uint8_t* section, uint32_t size, GuidedField& out)>
FieldError read_part(const uint8_t* bytes, uint32_t type, Need need, FieldError missing, GuidedField& out)
{
    Section section;
    if (!find_section(bytes, type, section)) return need == Need::required ? missing : FieldError::none;
    if (need == Need::none) return FieldError::unused_section;
    return kRead(bytes + section.offset, section.size, out);
}

FieldError read_surface(const uint8_t* bytes, GuidedField& out)
{
    const bool meshed = out.surface == GuidedSurface::proxy;
    const Need need = meshed ? Need::required : Need::none;
    return read_part<read_proxy>(bytes, kProxySection, need, FieldError::missing_proxy, out);
}

FieldError read_colour_parts(const uint8_t* bytes, GuidedField& out)
{
    const bool charted = out.texel != GuidedTexel::none;
    const Need chart = charted ? Need::required : Need::none;
    const Need mean = charted ? Need::optional : Need::required;
    const Need occlusion = charted && out.surface == GuidedSurface::proxy ? Need::optional : Need::none;
    FieldError error = read_part<read_mean>(bytes, kMeanSection, mean, FieldError::missing_mean, out);
    if (error != FieldError::none) return error;
    error = read_part<read_chart>(bytes, kChartSection, chart, FieldError::missing_chart, out);
    if (error != FieldError::none) return error;
    error = read_part<read_colours>(bytes, kChartColours, chart, FieldError::missing_chart_colours, out);
    if (error != FieldError::none) return error;
    return read_part<read_occlusion>(bytes, kOcclusionSection, occlusion, FieldError::none, out);
}

}  // namespace

FieldError open_guided(const uint8_t* bytes, size_t size, GuidedField& out)
{
    if (const FieldError error = check_table(bytes, size); error != FieldError::none) return error;
    Section section;
    if (!find_section(bytes, kGuidedSection, section)) {
        return has_section(bytes, kLayoutSection) ? FieldError::chord_field : FieldError::missing_guided;
    }
    const KnownTypes known = {kGuidedTypes, sizeof kGuidedTypes / sizeof *kGuidedTypes};
    if (const FieldError error = check_sections(bytes, known); error != FieldError::none) return error;
    if (section.size != kGuidedBytes) return FieldError::bad_guided;
    GuidedField field;
    if (const FieldError error = read_guided(bytes + section.offset, field); error != FieldError::none) return error;
    if (const FieldError error = read_surface(bytes, field); error != FieldError::none) return error;
    if (const FieldError error = read_colour_parts(bytes, field); error != FieldError::none) return error;
    out = field;
    return FieldError::none;
}

}  // namespace lumi
