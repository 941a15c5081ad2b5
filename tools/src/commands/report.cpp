// SPDX-License-Identifier: MIT
// lumi report: how good fields look, measured from views that no bake has aimed at.
#include <cstdio>
#include <memory>

#include "../quality/page.h"
#include "../quality/report_data.h"
#include "commands/commands.h"
#include "commands/rates.h"
#include "commands/scene_options.h"
#include "files/output_file.h"
#include "program/choice.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::tools
{

namespace
{

struct ReportOptions {
    SceneOptions scene;
    std::vector<std::string> fields;
    std::string output, json, cache;
    quality::ViewSet set = quality::ViewSet::all;
    int views = quality::kHeldOutViews;
    baker::ReferenceSettings reference = {256, 1, 0, false};
    std::vector<quality::DrawMode> modes;
    int size_px = quality::kViewSidePx;
};

// Bar and all. What is traced is kept, so a stop loses little.
std::vector<quality::Reference> traced(const ReportOptions& options, const baker::Scene& scene,
                                       const std::vector<quality::HeldOutView>& views)
{
    std::fputs("references\n", stderr);
    ProgressPrinter printer(stderr, stderr_is_terminal());
    try {
        return quality::references_of(scene, views, options.reference, options.cache, watch(printer));
    } catch (const baker::Cancelled&) {
        throw Interrupted("what was traced so far is kept for the next call");
    }
}

// Opened before anything is traced, so that a wrong file costs no time.
using Files = std::vector<std::unique_ptr<FieldFile>>;

Files open_all(const std::vector<std::string>& paths)
{
    Files files;
    for (const std::string& path : paths) {
        files.push_back(std::make_unique<FieldFile>(path));
        files.back()->require_intact();
    }
    return files;
}

quality::ReportData report_of(const ReportOptions& options, const baker::Scene& scene, const Files& fields)
{
    quality::ReportData report;
    report.scene = options.scene.path;
    report.set = options.set;
    report.reference_samples = options.reference.samples;
    report.views = quality::held_out_views(options.set, options.views, options.size_px);
    report.references = traced(options, scene, report.views);
    for (const auto& field : fields) {
        report.fields.push_back(quality::measured_field(*field, report.views, report.references));
        for (auto& variant : quality::measured_variants(*field, options.modes, report.views, report.references))
            report.variants.push_back(std::move(variant));
    }
    return report;
}

void run(ReportOptions& options)
{
    announce_outputs({options.output, options.json});
    options.reference.threads = options.scene.threads;
    const Files fields = open_all(options.fields);
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    const quality::ReportData report = report_of(options, scene, fields);
    std::fputs(text_of(report).c_str(), stdout);
    for (const auto& field : fields) std::printf("%s: %s", field->path().c_str(), rates_text(*field).c_str());
    if (!options.json.empty()) write_output(options.json, json_of(report));
    if (!options.output.empty()) write_output(options.output, page_of(report));
}

void add_modes(CLI::App& command, std::vector<quality::DrawMode>& modes)
{
    command
        .add_option_function<std::vector<std::string>>(
            "--mode",
            [&modes](const std::vector<std::string>& words) {
                for (const std::string& word : words) {
                    const auto mode = quality::parse_draw_mode(word);
                    if (!mode)
                        throw CLI::ValidationError(
                            "--mode", std::string("takes ") + quality::kDrawModeWords + "; not \"" + word + "\"");
                    modes.push_back(*mode);
                }
            },
            std::string("Also draw chord fields by these modes: ") + quality::kDrawModeWords)
        ->delimiter(',')
        ->type_name("LIST");
}

}  // namespace

void add_report(CLI::App& lumi)
{
    auto options = std::make_shared<ReportOptions>();
    options->cache = "lumi-report";
    CLI::App* command = lumi.add_subcommand("report", "Measure how good fields look, from views that no bake aimed at");
    add_scene_options(*command, options->scene);
    command->add_option("FIELD", options->fields, "Field files of the scene")->required();
    command->add_option("-o,--output", options->output, "Page to write: pictures and error maps, all in one file")
        ->type_name("OUT.html");
    command->add_option("--json", options->json, "Write all figures here as JSON")->type_name("FILE");
    add_choice<quality::ViewSet>(
        *command, "--views", options->set,
        {{"all", quality::ViewSet::all}, {"upper", quality::ViewSet::upper}, {"ring", quality::ViewSet::ring}}, "SET",
        "Where views lie: all around, upper half, or ring [all]");
    constexpr int kMaxViews = 100;
    command->add_option("--count", options->views, "Number of views")
        ->check(whole_number(1, kMaxViews))
        ->type_name("COUNT")
        ->capture_default_str();
    command->add_option("--spp", options->reference.samples, "Light paths per pixel of the references")
        ->check(whole_number(1, kMostPaths))
        ->type_name("S")
        ->capture_default_str();
    command->add_option("--cache", options->cache, "Folder for references, kept for the next report")
        ->type_name("DIR")
        ->capture_default_str();
    add_modes(*command, options->modes);
    constexpr int kLeastSide = 16, kMostSide = 2048;
    command->add_option("--size", options->size_px, "Pixels of a side of the square views")
        ->check(whole_number(kLeastSide, kMostSide))
        ->type_name("PX")
        ->capture_default_str();
    command->footer("Example:\n  lumi report product.obj small.lumi large.lumi -o report.html --json report.json");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
