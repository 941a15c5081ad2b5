// SPDX-License-Identifier: MIT
#include "files/field_report.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lumi/chord/render_spans.h"
#include "lumi/chord/texel.h"
#include "lumi/surface/states.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

constexpr double kRounding = 1e-6;  // binary32 rounds so, as a share of the sphere's radius

// Fields of both layouts have these.
struct Common {
    const char *layout, *texel_format, *colour_space;
};

template <class AnyField>
Common common_of(const AnyField& field, const char* layout, const char* texel_format)
{
    return {layout, texel_format, field.colour_space == ColourSpace::srgb ? "srgb" : "unknown"};
}

Common common_of(const FieldFile& file)
{
    if (file.is_surface()) return common_of(file.surface(), "surface", "palette8");
    return common_of(file.field(), "chord", detail::texel_name(file.field().texel_format));
}

uint32_t row_bytes_of(const Field& field)
{
    return field.directions.size() * detail::format::bytes_per_texel(field.texel_format);
}

// Header, table and alignment.
uint64_t other_bytes_of(const FieldFile& file)
{
    uint64_t bytes = file.size();
    for (const Section& section : file.sections()) bytes -= section.bytes;
    return bytes;
}

template <class... Values>
void append_line(std::string& text, const char* pattern, Values... values)
{
    char line[256];
    std::snprintf(line, sizeof line, pattern, values...);
    text += line;
    text += '\n';
}

void append_section(std::string& text, const FieldFile& file, const Section& section, bool verify)
{
    const char* state = !verify ? "" : file.is_intact(section) ? "  intact" : "  DAMAGED";
    append_line(text, "  %-4s  %10" PRIu32 "  %10" PRIu32 "  %5.1f %%  %08" PRIx32 "  %s%s", section.type.c_str(),
                section.offset, section.bytes, 100.0 * section.bytes / static_cast<double>(file.size()), section.crc32,
                section.required ? "required" : "optional", state);
}

std::string hexadecimal(uint32_t value)
{
    char text[16];
    std::snprintf(text, sizeof text, "%08" PRIx32, value);
    return text;
}

double longest_edge_of(const SurfaceField& field)
{
    constexpr double kOneQ6 = 64;
    return field.longest_edge_q6 / kOneQ6;
}

// In degrees, or in radii of the sphere.
struct PartRange {
    double from, to;
    bool is_free;
};

PartRange range_of(const PartMotion& motion)
{
    const double unit = motion.slides ? 1.0 / kOneQ20 : 360 / 0x1p32, from = motion.from * unit;
    return {from, from + motion.span * unit, !motion.slides && motion.span == UINT32_MAX};
}

bool is_draft(const FieldFile& file)
{
    const std::vector<Section> sections = file.sections();
    return std::any_of(sections.begin(), sections.end(), [](const Section& s) { return s.type == "DRFT"; });
}

void append_part(std::string& text, const std::string& name, const PartMotion& motion)
{
    const PartRange range = range_of(motion);
    const std::string shown = visible(name);
    if (range.is_free)
        append_line(text, "  moves         %s: turns, by any angle", shown.c_str());
    else
        append_line(text, "  moves         %s: %s from %g to %g %s", shown.c_str(), motion.slides ? "slides" : "turns",
                    range.from, range.to, motion.slides ? "radii" : "degrees");
}

void append_surface(std::string& text, const SurfaceField& field)
{
    append_line(text, "  mesh          %" PRIu32 " triangles in %" PRIu32 " patches, edges up to %.2f radii",
                triangles_of(field), field.patch_count, longest_edge_of(field));
    append_line(text, "  vertices      %" PRIu32 ", of which %" PRIu32 " with a view table", field.vertex_count,
                field.viewed_count);
    if (field.see_through_count != 0)
        append_line(text, "  see-through   %" PRIu32 " patches besides", field.see_through_count);
    for (uint32_t k = 0; k < mover_count(field); ++k) append_part(text, name_of_part(field, k), part_motion(field, k));
    for (uint32_t k = 0; k < field.state_count; ++k)
        append_line(text,
                    is_tint(field, k) ? "  tint          %s: its colour is chosen"
                                      : "  lights        %s: their weight is chosen",
                    visible(name_of_state(field, k)).c_str());
    if (gloss_count(field) != 0) append_line(text, "  gloss         %" PRIu32 " maps", gloss_count(field));
    if (field.neighbours == nullptr) text += "  neighbours    none: outlines cannot be drawn smooth\n";
}

void append_chord(std::string& text, const Field& field)
{
    append_line(text, "  origins       %" PRIu32 ", of which %" PRIu32 " used", field.origins.size(),
                field.used_origins);
    append_line(text, "  directions    %" PRIu32, field.directions.size());
    append_line(text, "  row           %" PRIu32 " bytes, %" PRIu32 " apart", row_bytes_of(field),
                field.row_stride_bytes);
}

nlohmann::ordered_json json_of_part(const SurfaceField& field, uint32_t part)
{
    const PartMotion motion = part_motion(field, part);
    const PartRange range = range_of(motion);
    const auto triple = [](const auto& v, double one) {
        return std::array<double, 3>{v.x / one, v.y / one, v.z / one};
    };
    nlohmann::ordered_json json = {{"name", name_of_part(field, part)},
                                   {"motion", motion.slides ? "slide" : "turn"},
                                   {"axis", triple(motion.axis, kOneQ30)},
                                   {"pivot", triple(motion.pivot, kOneQ20)}};
    if (!range.is_free) json.update({{"from", range.from}, {"to", range.to}});
    return json;
}

nlohmann::ordered_json json_of(const SurfaceField& field)
{
    nlohmann::ordered_json parts = nlohmann::ordered_json::array();
    for (uint32_t k = 0; k < mover_count(field); ++k) parts.push_back(json_of_part(field, k));
    nlohmann::ordered_json states = nlohmann::ordered_json::array();
    for (uint32_t k = 0; k < field.state_count; ++k) states.push_back(name_of_state(field, k));
    return {{"triangles", triangles_of(field)},
            {"patches", field.patch_count},
            {"see_through_patches", field.see_through_count},
            {"parts", parts},
            {"states", states},
            {"gloss", gloss_count(field)},
            {"vertices", field.vertex_count},
            {"viewed_vertices", field.viewed_count},
            {"texels", field.texel_bytes},
            {"neighbours", field.neighbours != nullptr},
            {"longest_edge", longest_edge_of(field)}};
}

nlohmann::ordered_json json_of(const Field& field)
{
    return {{"origins", field.origins.size()},
            {"used_origins", field.used_origins},
            {"directions", field.directions.size()},
            {"row_bytes", row_bytes_of(field)},
            {"row_stride_bytes", field.row_stride_bytes}};
}

}  // namespace

std::string name_of_part(const SurfaceField& field, uint32_t part)
{
    const PartName name = part_name(field, part);
    return std::string(name.text, name.bytes);
}

std::string name_of_state(const SurfaceField& field, uint32_t state)
{
    const StateName name = state_name(field, state);
    return std::string(name.text, name.bytes);
}

uint32_t triangles_of(const SurfaceField& field)
{
    uint32_t triangles = field.patch_count;
    for (uint32_t k = 0; k < field.patch_count; ++k)
        triangles += detail::surface_patch(field, k).corner[3] != detail::format::kNoVertex ? 1u : 0u;
    return triangles;
}

std::string report_text(const FieldFile& file, bool verify)
{
    const Common common = common_of(file);
    std::string text = file.path() + "\n";
    append_line(text, "  version       %" PRIu32, detail::format::kVersion);
    append_line(text, "  layout        %s", common.layout);
    append_line(text, "  bytes         %zu (%s)", file.size(), byte_text(file.size()).c_str());
    if (is_draft(file)) text += "  draft         yes: a first look; bake it without --draft to ship it\n";
    if (file.is_surface())
        append_surface(text, file.surface());
    else
        append_chord(text, file.field());
    const std::string count = file.is_surface() ? std::to_string(file.surface().texel_bytes) + ", " : "";
    append_line(text, "  texels        %s%s, %s", count.c_str(), common.texel_format, common.colour_space);
    const FieldSphere sphere = file.sphere();
    const auto radius = static_cast<double>(sphere.radius);
    // A number that is 0 but for rounding is 0 to people.
    const auto centre = [&](size_t k) {
        const auto place = static_cast<double>(sphere.centre[k]);
        return std::abs(place) < kRounding * radius ? 0 : place;
    };
    append_line(text, "  sphere        centre %g %g %g, radius %g (scene units)", centre(0), centre(1), centre(2),
                radius);
    append_line(text, "  drawn by      %s", renderer_of(file).example.c_str());
    text += "  type      offset       bytes    share  CRC-32\n";
    for (const Section& section : file.sections()) append_section(text, file, section, verify);
    append_line(text, "  header, table and alignment: %" PRIu64 " bytes", other_bytes_of(file));
    return text;
}

std::string report_json(const FieldFile& file, bool verify)
{
    const Common common = common_of(file);
    nlohmann::ordered_json json = {{"file", file.path()},
                                   {"bytes", file.size()},
                                   {"version", detail::format::kVersion},
                                   {"layout", common.layout},
                                   {"draft", is_draft(file)}};
    json.update(file.is_surface() ? json_of(file.surface()) : json_of(file.field()));
    json["texel_format"] = common.texel_format;
    json["colour_space"] = common.colour_space;
    json["centre"] = file.sphere().centre;
    json["radius"] = file.sphere().radius;
    json["drawn_by"] = renderer_of(file).example;
    json["sections"] = nlohmann::ordered_json::array();
    for (const Section& section : file.sections()) {
        json["sections"].push_back({{"type", section.type},
                                    {"required", section.required},
                                    {"offset", section.offset},
                                    {"bytes", section.bytes},
                                    {"crc32", hexadecimal(section.crc32)}});
        if (verify) json["sections"].back()["intact"] = file.is_intact(section);
    }
    json["other_bytes"] = other_bytes_of(file);
    // File names and section types may be any bytes; what is not UTF-8 must not stop the report.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

namespace
{

std::string texel_policy(TexelFormat format)
{
    std::string name = detail::texel_name(format);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return "lumi::Texel" + name;
}

// `drawing` lacks its last parameters and the closing bracket; an example has other ones.
RendererName named(const char* header, const char* opener, const char* parameters, const std::string& drawing,
                   const std::string& last, const std::string& last_of_example = "")
{
    return {header, opener, parameters, "lumi::View<" + drawing + ", " + last + ">, Screen>",
            "lumi::View<" + drawing + last_of_example + ">, lumi::Screen<240, 240, 16>>"};
}

RendererName renderer_of(const SurfaceField& field)
{
    const uint32_t patches = std::max<uint32_t>(field.patch_count, 1);  // memory for none is no array
    const std::string drawing =
        "lumi::SurfaceDrawing<" + std::to_string(field.vertex_count) + ", " + std::to_string(patches);
    std::string last = field.see_through_count == 0 ? "" : ", " + std::to_string(field.see_through_count);
    const uint32_t gloss = gloss_count(field);
    if (field.part_count + field.state_count + gloss != 0)
        last = ", " + std::to_string(field.see_through_count) + ", " +
               std::to_string(gloss != 0 ? field.viewed_count : field.vertex_count) + ", " +
               std::to_string(field.part_count);
    if (field.state_count + gloss != 0) last += ", " + std::to_string(field.state_count);
    if (gloss != 0) last += ", " + std::to_string(gloss);
    const bool is_plain = last.empty() && field.viewed_count == 0;
    return named("lumi/surface/view.h", "open_surface", "lumi::SurfaceMode Finest = lumi::SurfaceMode::antialiased",
                 drawing, "Finest" + (is_plain ? ", 0, 0" : last),
                 last.empty() ? "" : ", lumi::SurfaceMode::antialiased" + last);
}

}  // namespace

RendererName renderer_of(const FieldFile& field)
{
    if (field.is_surface()) return renderer_of(field.surface());
    const std::string drawing = fits_spans(field.field()) ? "ChordDrawing" : "ExactChordDrawing";
    return named("lumi/chord/view.h", "open_field", "class Reconstruction = lumi::Linear",
                 "lumi::" + drawing + "<" + texel_policy(field.field().texel_format), "Reconstruction");
}

}  // namespace lumi::tools
