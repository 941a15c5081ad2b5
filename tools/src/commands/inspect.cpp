// SPDX-License-Identifier: MIT
// lumi inspect: what a field file holds.
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "commands/device_figures.h"
#include "commands/device_options.h"
#include "draw/field_picture.h"
#include "files/field_mesh.h"
#include "files/field_report.h"
#include "files/output_file.h"
#include "image/png.h"
#include "program/choice.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

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
    if (!options.has_device) return text;
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

bool is_mesh_name(const std::string& path)
{
    return small_ending(path) == ".obj";
}

std::string wrong_png_or_obj_name(const std::string& path)
{
    return is_mesh_name(path) || wrong_png_name(path).empty()
               ? ""
               : "takes a picture (.png) or a mesh (.obj), not \"" + path + "\"";
}

void write(const InspectOptions& options, const FieldFile& file)
{
    file.require_intact();
    if (is_mesh_name(options.output))
        write_output(options.output, obj_of(file, options.up));
    else
        write_png(options.output, picture_of(file));
}

void run(const InspectOptions& options)
{
    announce_outputs({options.output});
    const FieldFile file(options.field);
    std::fputs((options.json ? json_of(options, file) : text_of(options, file)).c_str(), stdout);
    if (options.verify) file.require_intact();
    if (!options.output.empty()) write(options, file);
}

}  // namespace

void add_inspect(CLI::App& lumi)
{
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = lumi.add_subcommand("inspect", "Show what a field file holds and where its bytes go");
    command->add_option("FIELD", options->field, "A field file")->required();
    command
        ->add_option(
            "-o,--output", options->output,
            "Also write a picture: a surface field's texels, patch by patch, or what a chord field's origins see; "
            "or a surface field's mesh, in the units of its scene")
        ->type_name("OUT.png|OUT.obj")
        ->check(wrong_png_or_obj_name);
    add_choice<baker::UpAxis>(*command, "--up", options->up, {{"y", baker::UpAxis::y}, {"z", baker::UpAxis::z}},
                              "The scene's vertical axis, for the mesh: the one that it was baked with [y]");
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--verify", options->verify, "Check the CRC of every section; exit code 1 if one is damaged");
    add_screen_options(*command, options->screen);
    add_pace_option(*command, options->paces, "Of these parts: RAM, stack, and a model's frames a second");
    command->footer(
        "With --screen, --rows or --for it also tells what a device needs to draw the field.\n"
        "Example:\n  lumi inspect product.lumi --verify\n  lumi inspect product.lumi -o texels.png\n  lumi inspect "
        "product.lumi --screen 466x466 --rows 8 --for "
        "esp32s3");
    command->callback([options, command] {
        for (const char* name : {"--screen", "--rows", "--for"}) options->has_device |= command->count(name) > 0;
        if (command->count("--up") > 0 && !is_mesh_name(options->output))
            throw UsageError("--up belongs to a mesh (-o OUT.obj)");
        run(*options);
    });
}

}  // namespace lumi::tools
