// SPDX-License-Identifier: MIT
// lumi report: how good fields look, measured from views that no bake has aimed at.
#include <cstdio>
#include <memory>
#include <set>

#include "../quality/baselines.h"
#include "../quality/page.h"
#include "../quality/report_data.h"
#include "commands/choice.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "files/output_file.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::tools
{

namespace
{

struct ReportOptions {
    SceneOptions scene;
    std::vector<std::string> fields;
    std::string output, json, bench, cache;
    quality::ViewSet set = quality::ViewSet::all;
    int views = quality::kHeldOutViews;
    baker::ReferenceSettings reference = {256, 1, 0, false};
    std::vector<quality::DrawMode> modes;
    int size_px = bench::kSidePx;
    bool baselines = true, zoom = false;
};

// One progress bar for each thing that is traced.
class Steps
{
public:
    template <class Work>
    auto operator()(const std::string& title, const Work& work)
    {
        std::fprintf(stderr, "%s\n", title.c_str());
        ProgressPrinter printer(stderr, stderr_is_terminal());
        try {
            return work(watch(printer));
        } catch (const baker::Cancelled&) {
            throw Interrupted("what was traced so far is kept for the next call");
        }
    }
};

// Sizes of the fields, each once, smallest first: fields of about the same size share their baselines.
std::vector<uint64_t> sizes_of(const std::vector<quality::Measured>& fields)
{
    constexpr double kSame = 1.1;
    std::multiset<uint64_t> all;
    for (const quality::Measured& field : fields) all.insert(field.flash_bytes);
    std::vector<uint64_t> sizes;
    for (const uint64_t size : all)
        if (sizes.empty() || static_cast<double>(size) > kSame * static_cast<double>(sizes.back()))
            sizes.push_back(size);
    return sizes;
}

void measure_baselines(const ReportOptions& options, const baker::Scene& scene, quality::ReportData& report)
{
    Steps step;
    quality::BaselineSettings settings;
    settings.threads = options.reference.threads;
    settings.views = options.set;
    for (const uint64_t size : sizes_of(report.fields)) {
        if (quality::chord_side(size) > 0)
            report.baselines.push_back(step("chord field of the same size", [&](const auto& progress) {
                return quality::measured_chord(scene, size, settings, options.cache, report.views, report.references,
                                               progress);
            }));
        for (auto& sheet : quality::measured_sprites(scene, size, settings, report.views, report.references))
            report.baselines.push_back(std::move(sheet));
    }
    if (options.set == quality::ViewSet::ring) return;  // as all around
    const auto one_ray = step("one exact ray a pixel", [&](const auto& progress) {
        return quality::one_ray_pictures(scene, report.views, options.reference, options.cache, progress);
    });
    size_t next = 0;
    report.one_ray = quality::measured(
        "one exact ray a pixel", "one ray", 0, [&](const auto&) { return one_ray[next++].picture; }, report.views,
        report.references);
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
    report.references = Steps()("references", [&](const auto& progress) {
        return quality::references_of(scene, report.views, options.reference, options.cache, progress);
    });
    for (const auto& field : fields) {
        report.fields.push_back(quality::measured_field(*field, report.views, report.references));
        if (options.zoom && field->is_surface()) report.fields.back().flicker = quality::zoom_flicker(field->surface());
        for (auto& variant : quality::measured_variants(*field, options.modes, report.views, report.references))
            report.variants.push_back(std::move(variant));
    }
    if (options.baselines) measure_baselines(options, scene, report);
    return report;
}

void run(ReportOptions& options)
{
    announce_outputs({options.output, options.json});
    std::vector<quality::ModeCost> costs;
    if (!options.bench.empty()) costs = quality::read_mode_costs(options.bench);
    options.reference.threads = options.scene.threads;
    const Files fields = open_all(options.fields);
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    quality::ReportData report = report_of(options, scene, fields);
    report.costs = std::move(costs);
    std::fputs(text_of(report).c_str(), stdout);
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
    command->add_option("-o,--output", options->output, "Page to write: pictures, error maps, curves, all in one file")
        ->type_name("OUT.html");
    command->add_option("--bench", options->bench, "Also show what modes cost: the JSON of lumi bench")
        ->type_name("FILE");
    command->add_option("--json", options->json, "Write all figures here as JSON")->type_name("FILE");
    add_choice<quality::ViewSet>(
        *command, "--views", options->set,
        {{"all", quality::ViewSet::all}, {"upper", quality::ViewSet::upper}, {"ring", quality::ViewSet::ring}}, "SET",
        "Where views lie: all around, upper half, or ring [all]");
    constexpr int kMaxViews = 100;
    command->add_option("--count", options->views, "Number of views")
        ->check(CLI::Range(1, kMaxViews))
        ->type_name("COUNT")
        ->capture_default_str();
    command->add_option("--spp", options->reference.samples, "Light paths per pixel of the references")
        ->check(CLI::PositiveNumber)
        ->type_name("S")
        ->capture_default_str();
    command->add_option("--cache", options->cache, "Folder for references and chord fields, kept for the next report")
        ->type_name("DIR")
        ->capture_default_str();
    add_modes(*command, options->modes);
    constexpr int kLeastSide = 16, kMostSide = 2048;
    command->add_option("--size", options->size_px, "Pixels of a side of the square views")
        ->check(CLI::Range(kLeastSide, kMostSide))
        ->type_name("PX")
        ->capture_default_str();
    command->add_flag_callback(
        "--no-baselines", [&baselines = options->baselines] { baselines = false; },
        "Leave out chord fields, sprites and the exact ray");
    command->add_flag("--zoom", options->zoom,
                      "Also measure how much surface fields flicker while the eye moves away slowly");
    command->footer("Example:\n  lumi report product.obj small.lumi large.lumi -o report.html --json report.json");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
