// SPDX-License-Identifier: MIT
// lumi inspect: what a field file holds.
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/device_figures.h"
#include "files/field_file.h"
#include "files/field_report.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct InspectOptions {
    std::string field;
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

void run(const InspectOptions& options)
{
    std::optional<Waiting> waiting(std::in_place, "reading");
    const FieldFile file(options.field);
    waiting->now("drawing poses to time them");
    const std::string text = options.json ? json_of(options, file) : text_of(options, file);
    waiting.reset();
    print(stdout, "%s", text.c_str());
    if (options.verify) file.require_intact();
}

}  // namespace

void add_inspect(CLI::App& lumi)
{
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = lumi.add_subcommand("inspect", "Show what a field file holds and where its bytes go");
    command->add_option("FIELD", options->field, "A field file")->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--verify", options->verify, "Check the CRC of every section; exit code 1 if one is damaged");
    add_screen_options(*command, options->screen);
    add_pace_option(*command, options->paces, "Of these parts: RAM, stack, and a model's frames a second");
    command->footer(
        "It tells what a device needs to draw the field; in JSON with --screen, --rows or --for.\n"
        "Example:\n  lumi inspect product.lumi --verify\n  lumi inspect product.lumi --screen 466x466 --rows 8 --for "
        "esp32s3");
    command->callback([options, command] {
        for (const char* name : {"--screen", "--rows", "--for"}) options->has_device |= command->count(name) > 0;
        run(*options);
    });
}

}  // namespace lumi::tools
