// SPDX-License-Identifier: MIT
// lumi report: how good fields look, measured from views that no bake has aimed at.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "../quality/page.h"
#include "../quality/report_data.h"
#include "../trade/page.h"
#include "../trade/text.h"
#include "commands/camera_options.h"
#include "commands/commands.h"
#include "commands/device_figures.h"
#include "commands/ladder.h"
#include "commands/part_options.h"
#include "commands/scene_options.h"
#include "commands/scene_words.h"
#include "commands/state_options.h"
#include "files/output_file.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct ReportOptions {
    SceneOptions scene;
    std::string words;  // by which `lumi bake` reads the scene
    std::vector<std::string> fields;
    std::string output, cache;
    bool json = false, is_quick = false;
    std::vector<planner::Pace> paces;
    quality::ViewSet set = quality::ViewSet::all;
    int views = quality::kHeldOutViews;
    baker::ReferenceSettings reference = {256, 1, 0};
    std::vector<quality::DrawMode> modes;
    int size_px = quality::kViewSidePx;
};

// Bar and all. What is traced is kept, so a stop loses little.
std::vector<quality::Reference> traced(const ReportOptions& options, const baker::Scene& scene,
                                       const std::vector<quality::HeldOutView>& views)
{
    print(stderr, "references\n");
    ProgressPrinter printer(stderr, stderr_is_terminal());
    try {
        return quality::references_of(scene, views, options.reference, options.cache, watch(printer));
    } catch (const baker::Cancelled&) {
        throw Interrupted("what was traced so far is kept for the next call");
    }
}

// As a display of the parts shows them; without parts, as a screen does.
quality::Way way_of(const ReportOptions& options)
{
    return quality::finest(options.paces.empty() ? DisplayFormat::rgb888 : DisplayFormat::rgb565);
}

std::vector<quality::DrawMode> modes_of(const ReportOptions& options)
{
    return options.modes.empty() && !options.paces.empty() ? trade::usual_modes() : options.modes;
}

// Opened before anything is traced, so that a wrong file costs no time.
trade::Files open_all(const std::vector<std::string>& paths, FieldFile::Role role)
{
    const Waiting waiting("reading fields");
    trade::Files files;
    for (const std::string& path : paths) {
        files.push_back(std::make_unique<FieldFile>(path, role));
        files.back()->require_intact();
    }
    return files;
}

std::vector<PartPose> posed(const std::vector<baker::PartOptions>& parts)
{
    std::vector<PartPose> poses;
    for (const baker::PartOptions& part : parts)
        if (part.value != 0) poses.push_back({part.name, part.value, part.value});
    return poses;
}

quality::ReportData report_of(const ReportOptions& options, const baker::Scene& scene, const trade::Files& fields)
{
    quality::ReportData report;
    report.scene = options.scene.path;
    report.set = options.set;
    report.reference_samples = options.reference.samples;
    report.views = quality::held_out_views(options.set, options.views, options.size_px);
    report.references = traced(options, scene, report.views);
    quality::Yardstick by = {report.views, report.references, way_of(options)};
    const Waiting waiting("measuring fields");
    for (const auto& field : fields) {
        by.way.surface.parts = values_of(posed(options.scene.parts), *field);
        by.way.surface.states = values_of(options.scene.states, options.scene.base_colours, *field);
        report.fields.push_back(quality::measured_field(*field, by));
        for (auto& variant : quality::measured_variants(*field, modes_of(options), by))
            report.variants.push_back(std::move(variant));
    }
    return report;
}

void tell_quality(const ReportOptions& options, const quality::ReportData& report, const trade::Files& fields)
{
    std::string text = options.json ? json_of(report) : text_of(report);
    if (!options.json) {
        const Waiting waiting("drawing poses to time them");
        for (const auto& field : fields) text += field->path() + ": " + device_text(*field);
    }
    print(stdout, "%s", text.c_str());
    const Waiting waiting("making the page");
    if (!options.output.empty()) write_output(options.output, page_of(report));
}

void tell_trade(const ReportOptions& options, const quality::ReportData& report, const trade::Trade& trade)
{
    const std::string text =
        options.json ? with_trade(json_of(report), trade) : text_of(trade) + "\n" + text_of(report);
    print(stdout, "%s", text.c_str());
    const Waiting waiting("making the page");
    if (!options.output.empty()) write_output(options.output, page_of(report, lead_of(trade, report)));
}

Ladder ladder_of(const ReportOptions& options, const baker::Scene& scene)
{
    require_other_light(scene, options.scene.path);
    const std::filesystem::path folder = std::filesystem::path(options.cache) / quality::cache_key(scene);
    Ladder ladder = baked_ladder(scene, {folder.string(), options.is_quick, options.scene.threads, options.words});
    if (ladder.fields.empty())
        throw Failure(options.scene.path, "no surface field of up to 500 kB suits it",
                      "bake a larger one, and name it");
    return ladder;
}

// The fields of all poses, weights and base colours are the same.
Ladder ladder_of_choices(const ReportOptions& options)
{
    std::vector<std::string> told_already;
    return ladder_of(options, load_scene(without_choices(options.scene), told_already));
}

void warn_of_spheres(const ReportOptions& options, const baker::Scene& scene, const trade::Files& fields)
{
    for (const auto& field : fields)
        if (!has_sphere_of(*field, scene))
            print(stderr,
                  "lumi: warning: %s: its sphere is not that of %s; name the scene of its bake, and the same --frame, "
                  "--animation, --iso and --part\n",
                  field->path().c_str(), options.scene.path.c_str());
}

void run(ReportOptions& options)
{
    announce_outputs({options.output});
    options.reference.threads = options.scene.threads;
    trade::Files fields = open_all(options.fields, FieldFile::Role::input);
    if (!options.scene.states.empty())
        for (const auto& field : fields) add_unnamed(*field, options.scene.states);
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    warn_of_spheres(options, scene, fields);
    Ladder ladder;
    if (fields.empty()) {
        ladder = has_choices(options.scene) ? ladder_of_choices(options) : ladder_of(options, scene);
        fields = open_all(ladder.fields, FieldFile::Role::own_output);
    }
    const quality::ReportData report = report_of(options, scene, fields);
    if (options.paces.empty()) return tell_quality(options, report, fields);
    std::optional<Waiting> waiting(std::in_place, "drawing poses to time them");
    const trade::Trade trade = trade::trade_of(report, fields, options.paces, ladder.bakes);
    waiting.reset();
    tell_trade(options, report, trade);
}

// Values that --quick leaves to the caller where the caller says them.
void make_quick(const CLI::App& command, ReportOptions& options)
{
    constexpr int kViews = 4;
    constexpr uint32_t kSamples = 64;
    if (command.count("--count") == 0) options.views = kViews;
    if (command.count("--spp") == 0) options.reference.samples = kSamples;
}

void add_modes(CLI::App& command, std::vector<quality::DrawMode>& modes)
{
    const auto set = [&modes](const std::string& word) {
        const auto mode = quality::parse_draw_mode(word);
        if (!mode)
            throw CLI::ValidationError("--mode",
                                       std::string("takes ") + quality::kDrawModeWords + "; not \"" + word + "\"");
        modes.push_back(*mode);
    };
    add_list(command, "--mode", set, std::string("Also draw chord fields by these modes: ") + quality::kDrawModeWords)
        ->type_name("LIST");
}

}  // namespace

void add_report(CLI::App& lumi)
{
    auto options = std::make_shared<ReportOptions>();
    options->cache = "lumi-report";
    CLI::App* command = lumi.add_subcommand(
        "report", "Measure how good fields look, from views that no bake aimed at, and what that costs");
    add_scene_options(*command, options->scene);
    add_part_option(*command, options->scene.parts, PartWords::motion_and_pose);
    add_state_option(*command, options->scene.states, StateWords::weights);
    add_colour_option(*command, options->scene.base_colours);
    add_thread_option(*command, options->scene);
    command->add_option("FIELD", options->fields,
                        "Field files of the scene; with --for and none, fields of 60 kB to 4 MB are baked and kept in "
                        "the cache");
    command->add_option("-o,--output", options->output, "Page to write: pictures and error maps, all in one file")
        ->type_name("OUT.html")
        ->check(wrong_page_name);
    command->add_flag("--json", options->json, "Print all figures as JSON");
    add_pace_option(*command, options->paces,
                    "Weigh accuracy against speed and memory on these parts, and recommend what to take");
    add_choice<quality::ViewSet>(*command, "--views", options->set,
                                 {{"all", quality::ViewSet::all}, {"upper", quality::ViewSet::upper}},
                                 "Where views lie: all around, or in the upper half [all]");
    constexpr int kMaxViews = 100;
    command->add_option("--count", options->views, "Number of views")
        ->check(whole_number(1, kMaxViews))
        ->type_name("COUNT")
        ->capture_default_str();
    command->add_option("--spp", options->reference.samples, "Light paths per pixel of the references")
        ->check(whole_number(1, kMostPaths))
        ->type_name("S")
        ->capture_default_str();
    command->add_option("--cache", options->cache, "Folder for references and baked fields, kept for the next report")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_flag("--quick", options->is_quick,
                      "4 views, 64 light paths a pixel; of the baked fields fewer, with few light paths");
    add_modes(*command, options->modes);
    constexpr int kLeastSide = 16, kMostSide = 2048;
    command->add_option("--size", options->size_px, "Pixels of a side of the square views")
        ->check(whole_number(kLeastSide, kMostSide))
        ->type_name("PX")
        ->capture_default_str();
    command->footer(
        "Example:\n  lumi report product.obj small.lumi large.lumi -o report.html\n"
        "  lumi report product.obj -o report.html --for rp2040,esp32s3@20fps");
    command->callback([options, command] {
        if (options->fields.empty() && options->paces.empty())
            throw UsageError("report takes fields, or --for with parts such as rp2040 to bake some");
        if (options->is_quick) make_quick(*command, *options);
        options->words = scene_words(*command, options->scene);
        run(*options);
    });
}

}  // namespace lumi::tools
