// SPDX-License-Identifier: MIT
// lumi-lab baselines: what else so many bytes show.
#include <memory>

#include "commands/scene_options.h"
#include "comparison/baselines.h"
#include "measure/commands.h"
#include "quality/report_data.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::lab
{

namespace
{

struct Options {
    tools::SceneOptions scene;
    std::string cache = "lumi-report";
    uint64_t bytes = 0;
    int views = quality::kHeldOutViews;
    uint32_t samples = 256;
};

void measure(const Options& options, const baker::Scene& scene, const baker::ProgressCallback& progress)
{
    quality::ReportData report = {options.scene.path, quality::ViewSet::all, options.samples, {}, {}, {}, {}};
    report.views = quality::held_out_views(quality::ViewSet::all, options.views);
    const baker::ReferenceSettings tracing = {options.samples, 1, options.scene.threads, false};
    report.references = quality::references_of(scene, report.views, tracing, options.cache, progress);
    quality::BaselineSettings settings;
    settings.threads = options.scene.threads;
    if (quality::chord_side(options.bytes) > 0)
        report.fields.push_back(quality::measured_chord(scene, options.bytes, settings, options.cache, report.views,
                                                        report.references, progress));
    for (auto& sheet : quality::measured_sprites(scene, options.bytes, settings, report.views, report.references))
        report.fields.push_back(std::move(sheet));
    const auto one_ray = quality::one_ray_pictures(scene, report.views, tracing, options.cache, progress);
    size_t next = 0;
    report.fields.push_back(quality::measured(
        "one exact ray a pixel", "one ray", 0, [&](const auto&) { return one_ray[next++].picture; }, report.views,
        report.references));
    std::printf("%s", json_of(report).c_str());
}

void run(const Options& options)
{
    size_t warnings = 0;
    const baker::Scene scene = tools::load_scene(options.scene, warnings);
    tools::ProgressPrinter printer(stderr, tools::stderr_is_terminal());
    try {
        measure(options, scene, tools::watch(printer));
    } catch (const baker::Cancelled&) {
        throw tools::Interrupted("what was traced so far is kept for the next call");
    }
}

}  // namespace

void add_baselines(CLI::App& lab)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = lab.add_subcommand(
        "baselines", "Measure what else so many bytes show: a chord field, sprites; and one exact ray a pixel");
    add_scene_options(*command, options->scene);
    command->add_option("--bytes", options->bytes, "Flash for each of them")->required();
    command->add_option("--count", options->views, "Number of views")->capture_default_str();
    command->add_option("--spp", options->samples, "Light paths per pixel of the references")->capture_default_str();
    command->add_option("--cache", options->cache, "Folder of references, that of lumi report")->capture_default_str();
    command->callback([options] { run(*options); });
}

}  // namespace lumi::lab
