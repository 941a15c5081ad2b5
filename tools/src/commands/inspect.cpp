// SPDX-License-Identifier: MIT
// lumi inspect: what a field file holds.
#include <array>
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/device_figures.h"
#include "files/field_file.h"
#include "files/field_report.h"
#include "files/output_file.h"
#include "image/picture_file.h"
#include "lumi/baker/scene.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

using Place = std::array<double, 3>;

// From the sphere's frame, where z points up, to the scene's axes.
Place in_scene_axes(const detail::VertexQ14& v, baker::UpAxis up)
{
    constexpr double kOneQ14 = 1 << 14;
    const double x = v.x / kOneQ14, y = v.y / kOneQ14, z = v.z / kOneQ14;
    return up == baker::UpAxis::y ? Place{y, z, x} : Place{x, y, z};
}

void append_vertex(const Place& p, const FieldSphere& sphere, std::string& text)
{
    const auto in_units = [&](size_t k) {
        return static_cast<double>(sphere.centre[k]) + static_cast<double>(sphere.radius) * p[k];
    };
    char line[96];
    std::snprintf(line, sizeof line, "v %.7g %.7g %.7g\n", in_units(0), in_units(1), in_units(2));
    text += line;
}

void append_face(uint32_t a, uint32_t b, uint32_t c, std::string& text)
{
    char line[64];  // vertices count from 1
    std::snprintf(line, sizeof line, "f %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", a + 1, b + 1, c + 1);
    text += line;
}

void append_group(const SurfaceField& field, const std::string& name, uint32_t begin, uint32_t end, std::string& text)
{
    if (begin == end) return;
    text += "g " + name + "\n";
    for (uint32_t k = begin; k < end; ++k) {
        const auto& corner = detail::surface_patch(field, k).corner;
        append_face(corner[0], corner[1], corner[2], text);
        if (corner[3] != detail::format::kNoVertex) append_face(corner[3], corner[2], corner[1], text);
    }
}

// An OBJ file: vertices in the scene's units and axes, of which `up` is the vertical one; the triangles
// counter-clockwise seen from outside, in a group opaque, one for each moving part, and, where there are some, a group
// see_through. Throws Failure for a chord field, which has no mesh.
std::string obj_of(const FieldFile& file, baker::UpAxis up)
{
    if (!file.is_surface())
        throw Failure(file.path(), "a chord field is a table of rays and has no mesh",
                      "bake a surface field (lumi bake --layout surface)");
    const SurfaceField& field = file.surface();
    std::string text = std::string(kMeshMark) + ", in the units of its scene; written by lumi inspect\n";
    for (uint32_t k = 0; k < field.vertex_count; ++k)
        append_vertex(in_scene_axes(detail::surface_vertex(field, k), up), file.sphere(), text);
    uint32_t begin = 0;
    std::string name = "opaque";
    for (uint32_t part = 0; part < mover_count(field); ++part) {
        const uint32_t end = first_patch_of_part(field, part);
        append_group(field, name, begin, end, text);
        name = replaced(visible(name_of_part(field, part)), " ", "_");
        begin = end;
    }
    append_group(field, name, begin, field.patch_count, text);
    append_group(field, "see_through", field.patch_count, field.patch_count + field.see_through_count, text);
    return text;
}

struct InspectOptions {
    std::string field, output;
    baker::UpAxis up = baker::UpAxis::y;
    bool json = false, verify = false, has_device = false;
    host::ScreenSize screen;
    std::vector<planner::Pace> paces;
};

Device device_of(const InspectOptions& options)
{
    Device device = {options.screen, {}};
    for (const planner::Pace& pace : options.paces) device.parts.push_back(pace.chip);
    return device;
}

std::string text_of(const InspectOptions& options, const FieldFile& file)
{
    std::string text = report_text(file, options.verify);
    text += device_text(file, device_of(options));
    for (const planner::Pace& pace : options.paces) text += pace_text(file, pace, options.screen);
    return text;
}

std::string json_of(const InspectOptions& options, const FieldFile& file)
{
    const std::string report = report_json(file, options.verify);
    if (!options.has_device) return report;
    auto json = nlohmann::ordered_json::parse(report);
    json.update(device_json(file, device_of(options)));
    return json.dump(2) + "\n";
}

std::string wrong_mesh_name(const std::string& path)
{
    return small_ending(path) == ".obj" ? "" : "takes a mesh (.obj), not \"" + path + "\"";
}

void write_mesh(const InspectOptions& options, const FieldFile& file)
{
    file.require_intact();
    write_output(options.output, obj_of(file, options.up));
}

void run(const InspectOptions& options)
{
    announce_outputs({options.output});
    std::optional<Waiting> waiting(std::in_place, "reading");
    const FieldFile file(options.field);
    waiting->now("drawing poses to time them");
    const std::string text = options.json ? json_of(options, file) : text_of(options, file);
    waiting.reset();
    print(stdout, "%s", text.c_str());
    if (options.verify) file.require_intact();
    if (!options.output.empty()) write_mesh(options, file);
}

}  // namespace

void add_inspect(CLI::App& lumi)
{
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = lumi.add_subcommand("inspect", "Show what a field file holds and where its bytes go");
    command->add_option("FIELD", options->field, "A field file")->required();
    CLI::Option* mesh =
        command
            ->add_option("-o,--output", options->output, "Also write a surface field's mesh, in the units of its scene")
            ->type_name("OUT.obj")
            ->check(wrong_mesh_name);
    add_choice<baker::UpAxis>(*command, "--up", options->up, {{"y", baker::UpAxis::y}, {"z", baker::UpAxis::z}},
                              "The scene's vertical axis, for the mesh: the one that it was baked with [y]")
        ->needs(mesh);
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--verify", options->verify, "Check the CRC of every section; exit code 1 if one is damaged");
    add_screen_options(*command, options->screen);
    add_pace_option(*command, options->paces, "Of these parts: RAM, stack, and a model's frames a second");
    command->footer(
        "It tells what a device needs to draw the field; in JSON with --screen, --rows or --for.\n"
        "Example:\n  lumi inspect product.lumi --verify\n  lumi inspect product.lumi -o mesh.obj\n  lumi inspect "
        "product.lumi --screen 466x466 --rows 8 --for "
        "esp32s3");
    command->callback([options, command] {
        for (const char* name : {"--screen", "--rows", "--for"}) options->has_device |= command->count(name) > 0;
        run(*options);
    });
}

}  // namespace lumi::tools
