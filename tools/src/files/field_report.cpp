// SPDX-License-Identifier: MIT
#include "files/field_report.h"

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "files/renderer_name.h"
#include "lumi/chord/texel.h"
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

const char* colour_space_name(ColourSpace space)
{
    return space == ColourSpace::srgb ? "srgb" : "unknown";
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
    report.row_bytes = field.directions.size() * detail::format::bytes_per_texel(field.texel_format);
    report.row_stride_bytes = field.row_stride_bytes;
    report.texel_format = detail::texel_name(field.texel_format);
    report.colour_space = colour_space_name(field.colour_space);
    report.centre = centre_of(field.centre_bits);
    report.radius = float_from_bits(field.radius_bits);
}

void describe_surface(const SurfaceField& field, FieldReport& report)
{
    report.layout = "surface";
    report.surface = field;
    report.texel_format = "palette8";
    report.colour_space = colour_space_name(field.colour_space);
    report.centre = centre_of(field.centre_bits);
    report.radius = float_from_bits(field.radius_bits);
}

double longest_edge_of(const SurfaceField& field)
{
    constexpr double kOneQ6 = 64;
    return field.longest_edge_q6 / kOneQ6;
}

void append_surface(std::string& text, const SurfaceField& field)
{
    append_line(text, "  mesh          %" PRIu32 " triangles in %" PRIu32 " patches%s, edges up to %.2f radii",
                triangles_of(field), field.patch_count, field.two_sided ? ", seen from both sides" : "",
                longest_edge_of(field));
    append_line(text, "  vertices      %" PRIu32 ", of which %" PRIu32 " with a view table", field.vertex_count,
                field.viewed_count);
    if (field.neighbours == nullptr) text += "  neighbours    none: outlines cannot be drawn smooth\n";
}

void append_chord(std::string& text, const FieldReport& report)
{
    append_line(text, "  origins       %" PRIu32 ", of which %" PRIu32 " used", report.origins, report.used_origins);
    append_line(text, "  directions    %" PRIu32, report.directions);
    append_line(text, "  row           %" PRIu32 " bytes, %" PRIu32 " apart", report.row_bytes,
                report.row_stride_bytes);
}

nlohmann::ordered_json json_of(const SurfaceField& field)
{
    return {{"triangles", triangles_of(field)},
            {"patches", field.patch_count},
            {"vertices", field.vertex_count},
            {"viewed_vertices", field.viewed_count},
            {"texels", field.texel_bytes},
            {"two_sided", field.two_sided},
            {"neighbours", field.neighbours != nullptr},
            {"longest_edge", longest_edge_of(field)}};
}

nlohmann::ordered_json chord_json(const FieldReport& report)
{
    return {{"origins", report.origins},
            {"used_origins", report.used_origins},
            {"directions", report.directions},
            {"row_bytes", report.row_bytes},
            {"row_stride_bytes", report.row_stride_bytes}};
}

}  // namespace

uint32_t triangles_of(const SurfaceField& field)
{
    uint32_t triangles = field.patch_count;
    for (uint32_t k = 0; k < field.patch_count; ++k)
        triangles += detail::surface_patch(field, k).corner[3] != detail::format::kNoVertex ? 1u : 0u;
    return triangles;
}

FieldReport describe_field(const FieldFile& file, bool verify)
{
    FieldReport report;
    report.path = file.path();
    report.file_bytes = file.size();
    report.version = detail::format::kVersion;
    if (file.is_surface())
        describe_surface(file.surface(), report);
    else
        describe_chord(file.field(), report);
    report.view = renderer_of(file).example;
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
    if (report.surface)
        append_surface(text, *report.surface);
    else
        append_chord(text, report);
    const std::string count = report.surface ? std::to_string(report.surface->texel_bytes) + ", " : "";
    append_line(text, "  texels        %s%s, %s", count.c_str(), report.texel_format.c_str(),
                report.colour_space.c_str());
    append_line(text, "  sphere        centre %g %g %g, radius %g (scene units)", static_cast<double>(report.centre[0]),
                static_cast<double>(report.centre[1]), static_cast<double>(report.centre[2]),
                static_cast<double>(report.radius));
    append_line(text, "  drawn by      %s", report.view.c_str());
    text += "  type      offset       bytes    share  CRC-32\n";
    for (const FieldReport::Entry& entry : report.sections) append_section(text, entry, report.file_bytes);
    append_line(text, "  header, table and alignment: %" PRIu64 " bytes", report.other_bytes);
    return text;
}

std::string json_of(const FieldReport& report)
{
    nlohmann::ordered_json json = {
        {"file", report.path}, {"bytes", report.file_bytes}, {"version", report.version}, {"layout", report.layout}};
    json.update(report.surface ? json_of(*report.surface) : chord_json(report));
    json["texel_format"] = report.texel_format;
    json["colour_space"] = report.colour_space;
    json["centre"] = report.centre;
    json["radius"] = report.radius;
    json["drawn_by"] = report.view;
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
