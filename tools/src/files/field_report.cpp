// SPDX-License-Identifier: MIT
#include "files/field_report.h"

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

float float_from_bits(uint32_t bits)
{
    float value;
    static_assert(sizeof value == sizeof bits, "a field stores IEEE binary32");
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

const char* colour_space_name(format::ColourSpace space)
{
    return space == format::ColourSpace::srgb ? "srgb" : "unknown";
}

template <class... Values>
void append_line(std::string& text, const char* pattern, Values... values)
{
    char line[256];
    std::snprintf(line, sizeof line, pattern, values...);
    text += line;
    text += '\n';
}

void append_section(std::string& text, const FieldReport::Entry& entry, uint64_t file_bytes)
{
    const Section& section = entry.section;
    const char* state = !entry.intact ? "" : *entry.intact ? "  intact" : "  DAMAGED";
    append_line(text, "  %-4s  %10" PRIu32 "  %10" PRIu32 "  %5.1f %%  %08" PRIx32 "  %s%s", section.type.c_str(),
                section.offset, section.bytes, 100.0 * section.bytes / static_cast<double>(file_bytes), section.crc32,
                section.required ? "required" : "optional", state);
}

std::string hexadecimal(uint32_t value)
{
    char text[16];
    std::snprintf(text, sizeof text, "%08" PRIx32, value);
    return text;
}

std::array<float, 3> centre_of(const uint32_t (&bits)[3])
{
    return {float_from_bits(bits[0]), float_from_bits(bits[1]), float_from_bits(bits[2])};
}

void describe_chord(const Field& field, FieldReport& report)
{
    report.layout = "chord";
    report.origins = field.origins.size();
    report.directions = field.directions.size();
    report.used_origins = field.used_origins;
    report.row_bytes = field.directions.size() * format::bytes_per_texel(field.texel_format);
    report.row_stride_bytes = field.row_stride_bytes;
    report.texel_format = name_of(field.texel_format);
    report.colour_space = colour_space_name(field.colour_space);
    report.centre = centre_of(field.centre_bits);
    report.radius = float_from_bits(field.radius_bits);
}

void describe_guided(const GuidedField& field, FieldReport& report)
{
    report.layout = "guided";
    report.guided = field;
    report.origins = field.origins.size();
    report.used_origins = field.used_origins;
    report.texel_format = name_of(field.texel);
    report.colour_space = colour_space_name(field.colour_space);
    report.centre = centre_of(field.centre_bits);
    report.radius = float_from_bits(field.radius_bits);
}

double radii_of_q14(int32_t q14)
{
    constexpr double kOne = 16384;
    return q14 / kOne;
}

bool has_chart(const GuidedField& field)
{
    return field.texel != format::GuidedTexel::none;
}

void append_guided(std::string& text, const GuidedField& field)
{
    if (field.surface == format::GuidedSurface::proxy) {
        append_line(text, "  surface       proxy, %" PRIu32 " vertices, %" PRIu32 " triangles%s",
                    field.proxy.vertex_count, field.proxy.triangle_count,
                    field.proxy.two_sided ? ", seen from both sides" : "");
    } else {
        append_line(text, "  surface       focus at %.3f %.3f %.3f, radius %.3f (in radii)",
                    radii_of_q14(field.focus_q14[0]), radii_of_q14(field.focus_q14[1]),
                    radii_of_q14(field.focus_q14[2]), radii_of_q14(field.focus_radius_q14));
    }
    if (has_chart(field))
        append_line(text,
                    "  charts        %" PRIu32 " grid points across, %" PRIu32 " texels, colours for %" PRIu32
                    " origins at a time",
                    field.chart_size, field.chart.texel_count, field.origins_per_palette);
    if (field.mean.resolution != 0)
        append_line(text, "  mean colours  %" PRIu32 " nodes across, %s, %" PRIu32 " bricks", field.mean.resolution,
                    name_of(field.mean.format), field.mean.brick_count);
}

void add_guided(nlohmann::ordered_json& json, const GuidedField& field)
{
    json["surface"] = name_of(field.surface);
    json["proxy_vertices"] = field.proxy.vertex_count;
    json["proxy_triangles"] = field.proxy.triangle_count;
    json["chart_size"] = has_chart(field) ? field.chart_size : 0;
    json["chart_texels"] = field.chart.texel_count;
    json["origins_per_palette"] = field.origins_per_palette;
    json["mean_resolution"] = field.mean.resolution;
    json["mean_format"] = field.mean.resolution != 0 ? name_of(field.mean.format) : "none";
    json["mean_bricks"] = field.mean.brick_count;
    json["occlusion_blocks"] = field.occlusion.texel_count;
}

}  // namespace

FieldReport describe_field(const FieldFile& file, bool verify)
{
    FieldReport report;
    report.path = file.path();
    report.file_bytes = file.size();
    report.version = format::kVersion;
    if (file.is_guided()) {
        describe_guided(file.guided(), report);
    } else {
        describe_chord(file.field(), report);
    }
    report.other_bytes = report.file_bytes;
    for (const Section& section : file.sections()) {
        report.sections.push_back({section, verify ? std::optional<bool>(file.is_intact(section)) : std::nullopt});
        report.other_bytes -= section.bytes;
    }
    return report;
}

std::string text_of(const FieldReport& report)
{
    std::string text = report.path + "\n";
    append_line(text, "  version       %" PRIu32, report.version);
    append_line(text, "  layout        %s", report.layout.c_str());
    append_line(text, "  bytes         %" PRIu64 " (%s)", report.file_bytes, byte_text(report.file_bytes).c_str());
    append_line(text, "  origins       %" PRIu32 ", of which %" PRIu32 " used", report.origins, report.used_origins);
    if (report.guided) {
        append_guided(text, *report.guided);
    } else {
        append_line(text, "  directions    %" PRIu32, report.directions);
    }
    append_line(text, "  texels        %s, %s", report.texel_format.c_str(), report.colour_space.c_str());
    if (!report.guided)
        append_line(text, "  row           %" PRIu32 " bytes, %" PRIu32 " apart", report.row_bytes,
                    report.row_stride_bytes);
    append_line(text, "  sphere        centre %g %g %g, radius %g (scene units)", static_cast<double>(report.centre[0]),
                static_cast<double>(report.centre[1]), static_cast<double>(report.centre[2]),
                static_cast<double>(report.radius));
    append_line(text, "  type      offset       bytes    share  CRC-32");
    for (const FieldReport::Entry& entry : report.sections) append_section(text, entry, report.file_bytes);
    append_line(text, "  header, table and alignment: %" PRIu64 " bytes", report.other_bytes);
    return text;
}

std::string json_of(const FieldReport& report)
{
    nlohmann::ordered_json json = {{"file", report.path},       {"bytes", report.file_bytes},
                                   {"version", report.version}, {"layout", report.layout},
                                   {"origins", report.origins}, {"used_origins", report.used_origins}};
    if (report.guided) {
        add_guided(json, *report.guided);
    } else {
        json["directions"] = report.directions;
    }
    json["texel_format"] = report.texel_format;
    json["colour_space"] = report.colour_space;
    if (!report.guided) {
        json["row_bytes"] = report.row_bytes;
        json["row_stride_bytes"] = report.row_stride_bytes;
    }
    json["centre"] = report.centre;
    json["radius"] = report.radius;
    json["sections"] = nlohmann::ordered_json::array();
    for (const FieldReport::Entry& entry : report.sections) {
        nlohmann::ordered_json section = {{"type", entry.section.type},
                                          {"required", entry.section.required},
                                          {"offset", entry.section.offset},
                                          {"bytes", entry.section.bytes},
                                          {"crc32", hexadecimal(entry.section.crc32)}};
        if (entry.intact) section["intact"] = *entry.intact;
        json["sections"].push_back(section);
    }
    json["other_bytes"] = report.other_bytes;
    // File names and section types may be any bytes; what is not UTF-8 must not stop the report.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace lumi::tools
