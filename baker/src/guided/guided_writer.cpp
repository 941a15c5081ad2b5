// SPDX-License-Identifier: MIT
#include "guided/guided_writer.h"

#include "lumi/baker/bake.h"
#include "store/section_writer.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kMaxOriginTexels = uint64_t{1} << 16;  // a row's place wraps there

std::vector<uint8_t> guided_section(const GuidedParts& parts)
{
    namespace at = format::guided;
    Bytes b(format::kGuidedBytes);
    b.put32(at::kOriginsAt, parts.origins);
    b.put32(at::kUsedOriginsAt, parts.used_origins);
    b.put16(at::kChartSizeAt, static_cast<uint16_t>(parts.chart_size));
    b.put8(at::kTexelAt, static_cast<uint8_t>(parts.texel));
    b.put8(at::kSurfaceAt, static_cast<uint8_t>(parts.surface));
    b.put8(at::kColourSpaceAt, static_cast<uint8_t>(format::ColourSpace::srgb));
    b.put16(at::kOriginsPerPaletteAt, static_cast<uint16_t>(parts.origins_per_palette));
    for (size_t axis = 0; axis < 3; ++axis) {
        b.put_float(at::kCentreAt + 4 * axis, parts.centre[axis]);
        b.put16(at::kFocusAt + 2 * axis, static_cast<uint16_t>(parts.focus_q14[axis]));
    }
    b.put_float(at::kRadiusAt, parts.radius);
    b.put16(at::kFocusRadiusAt, parts.focus_radius_q14);
    return b.take();
}

// Number n of all at bit 12·n.
void put_triples(Bytes& b, size_t at, const std::vector<PackedProxy::Triple>& triples)
{
    std::vector<uint16_t> numbers;
    for (const PackedProxy::Triple& t : triples) {
        numbers.insert(numbers.end(), t.begin(), t.end());
    }
    numbers.push_back(0);  // a partner for the last one
    const size_t end = at + format::triples_bytes(static_cast<uint32_t>(triples.size()));
    for (size_t n = 0; n + 1 < numbers.size(); n += 2, at += 3) {
        const uint32_t pair = numbers[n] | uint32_t{numbers[n + 1]} << 12;
        for (size_t byte = 0; byte < 3 && at + byte < end; ++byte) {
            b.put8(at + byte, static_cast<uint8_t>(pair >> 8 * byte));
        }
    }
}

std::vector<uint8_t> proxy_section(const PackedProxy& proxy)
{
    namespace at = format::proxy;
    const uint32_t vertices = static_cast<uint32_t>(proxy.vertices.size());
    const uint32_t triangles = static_cast<uint32_t>(proxy.triangles.size());
    const uint32_t triangles_at = format::proxy_triangles_at(vertices);
    Bytes b(triangles_at + format::triples_bytes(triangles));
    b.put16(at::kVerticesAt, static_cast<uint16_t>(vertices));
    b.put16(at::kTrianglesAt, static_cast<uint16_t>(triangles));
    b.put32(at::kFlagsAt, proxy.two_sided ? format::kTwoSided : 0);
    put_triples(b, at::kVertexBlockAt, proxy.vertices);
    put_triples(b, triangles_at, proxy.triangles);
    return b.take();
}

std::vector<uint8_t> mean_section(const PackedMean& mean)
{
    namespace at = format::mean;
    const bool indexed = mean.format == format::MeanFormat::palette8;
    const size_t index_at = at::kContentAt + (indexed ? format::kPaletteBytes : 0);
    const size_t bricks_at = index_at + (2 * mean.index.size() + 3) / 4 * 4;
    Bytes b(bricks_at + mean.bricks.size() * (indexed ? 1 : 2));
    b.put16(at::kResolutionAt, static_cast<uint16_t>(mean.resolution));
    b.put8(at::kFormatAt, static_cast<uint8_t>(mean.format));
    for (size_t axis = 0; axis < 3; ++axis) {
        b.put8(at::kFirstBrickAt + axis, mean.first_brick[axis]);
        b.put8(at::kBoxAt + axis, mean.box[axis]);
    }
    b.put16(at::kBricksAt, static_cast<uint16_t>(mean.bricks.size() / format::kBrickNodes));
    for (size_t k = 0; indexed && k < mean.palette.size(); ++k) {
        b.put8(at::kContentAt + 4 * k, mean.palette[k].r);
        b.put8(at::kContentAt + 4 * k + 1, mean.palette[k].g);
        b.put8(at::kContentAt + 4 * k + 2, mean.palette[k].b);
    }
    for (size_t k = 0; k < mean.index.size(); ++k) {
        b.put16(index_at + 2 * k, mean.index[k]);
    }
    for (size_t k = 0; k < mean.bricks.size(); ++k) {
        indexed ? b.put8(bricks_at + k, static_cast<uint8_t>(mean.bricks[k]))
                : b.put16(bricks_at + 2 * k, mean.bricks[k]);
    }
    return b.take();
}

struct ChartCounts {
    uint64_t rows = 0, texels = 0;
};

ChartCounts counts_of(const std::vector<PackedChart>& charts)
{
    ChartCounts sum;
    for (const PackedChart& chart : charts) {
        sum.rows += chart.rows.rows.size();
        sum.texels += chart.rows.texel_count;
    }
    return sum;
}

void put_directory(Bytes& b, const std::vector<PackedChart>& charts)
{
    namespace at = format::chart;
    uint32_t texel_base = 0, row_base = 0;
    size_t entry = at::kDirectoryAt;
    for (const PackedChart& chart : charts) {
        b.put32(entry + at::kTexelBaseAt, texel_base);
        b.put32(entry + at::kRowBaseAt, row_base);
        b.put16(entry + at::kFirstRowAt, static_cast<uint16_t>(chart.rows.first_v));
        b.put16(entry + at::kRowCountAt, static_cast<uint16_t>(chart.rows.rows.size()));
        texel_base += chart.rows.texel_count;
        row_base += static_cast<uint32_t>(chart.rows.rows.size());
        entry += at::kEntryBytes;
    }
}

// Two texels a byte, the even one in the low bits.
void put_texels(Bytes& b, size_t at, const std::vector<PackedChart>& charts, uint32_t bits)
{
    uint64_t number = 0;
    uint8_t pending = 0;
    for (const PackedChart& chart : charts) {
        for (const uint8_t texel : chart.texels) {
            if (bits == 8) {
                b.put8(at + number, texel);
            } else if (number % 2 == 0) {
                pending = texel;
                b.put8(at + number / 2, pending);
            } else {
                b.put8(at + number / 2, static_cast<uint8_t>(pending | texel << 4));
            }
            ++number;
        }
    }
}

std::vector<uint8_t> chart_section(const std::vector<PackedChart>& charts, uint32_t bits)
{
    namespace at = format::chart;
    const ChartCounts counts = counts_of(charts);
    const size_t rows_at = at::kDirectoryAt + charts.size() * at::kEntryBytes;
    const size_t texels_at = rows_at + (2 * counts.rows + 3) / 4 * 4;
    Bytes b(texels_at + (counts.texels * bits + 7) / 8);
    b.put32(at::kRowsAt, static_cast<uint32_t>(counts.rows));
    b.put32(at::kTexelsAt, static_cast<uint32_t>(counts.texels));
    put_directory(b, charts);
    size_t row_at = rows_at;
    for (const PackedChart& chart : charts) {
        for (const ChartRows::Row& row : chart.rows.rows) {
            b.put16(row_at, static_cast<uint16_t>(row.at - row.first_u));
            row_at += 2;
        }
    }
    put_texels(b, texels_at, charts, bits);
    return b.take();
}

void check_charts(const std::vector<PackedChart>& charts)
{
    for (const PackedChart& chart : charts) {
        if (chart.rows.texel_count > kMaxOriginTexels) {
            throw BakeError("an origin's chart would hold " + std::to_string(chart.rows.texel_count) +
                            " texels, and the format ends at 65536; choose a smaller --chart");
        }
    }
}

}  // namespace

std::vector<FieldSection> base_sections(const GuidedParts& parts)
{
    std::vector<FieldSection> sections;
    sections.push_back({format::kGuidedSection, guided_section(parts)});
    if (parts.surface == format::GuidedSurface::proxy) {
        sections.push_back({format::kProxySection, proxy_section(parts.proxy)});
    }
    if (parts.mean.resolution != 0) {
        sections.push_back({format::kMeanSection, mean_section(parts.mean)});
    }
    return sections;
}

std::vector<FieldSection> chart_sections(const GuidedParts& parts)
{
    check_charts(parts.charts);
    std::vector<FieldSection> sections;
    if (parts.texel != format::GuidedTexel::none) {
        const uint32_t bits = parts.texel == format::GuidedTexel::index4 ? 4 : 8;
        sections.push_back({format::kChartSection, chart_section(parts.charts, bits)});
        sections.push_back({format::kChartColours, parts.colours});
    }
    if (!parts.occluded.empty()) {
        sections.push_back({format::kOcclusionSection, chart_section(parts.occluded, 8)});
    }
    return sections;
}

std::vector<uint8_t> guided_file(const std::vector<FieldSection>& contents)
{
    std::vector<Section> sections;
    uint64_t size = head_bytes(contents.size());
    for (const FieldSection& part : contents) {
        sections.push_back({part.type, part.bytes.size(), crc_of(part.bytes)});
        size += aligned(part.bytes.size());
    }
    if (size > UINT32_MAX) {
        throw BakeError("the field would have " + std::to_string(size) +
                        " bytes, and a field file holds less than 4 GiB; choose fewer origins or a smaller chart");
    }
    std::vector<uint8_t> file = file_head(sections);
    for (const FieldSection& part : contents) {
        file.insert(file.end(), part.bytes.begin(), part.bytes.end());
        file.resize(aligned(file.size()));
    }
    return file;
}

std::vector<uint8_t> guided_file(const GuidedParts& parts)
{
    std::vector<FieldSection> sections = base_sections(parts);
    for (FieldSection& section : chart_sections(parts)) {
        sections.push_back(std::move(section));
    }
    return guided_file(sections);
}

}  // namespace lumi::baker
