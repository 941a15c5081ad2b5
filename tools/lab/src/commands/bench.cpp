// SPDX-License-Identifier: MIT
// lumi bench: what drawing costs on microcontrollers and how exact it is.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "bench/markdown.h"
#include "bench/measure.h"
#include "bench/plots.h"
#include "bench/report.h"
#include "bench/surface.h"
#include "commands/commands.h"
#include "files/output_file.h"
#include "lumi/baker/file_guard.h"
#include "lumi/baker/scene.h"
#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

struct BenchOptions {
    bench::Settings settings;
    std::string source = LUMI_SOURCE_DIR, work = "lumi-bench", scene, field, json, plots, markdown;
    bool quick = false;
};

// Paths of the plots as a page in `page`'s folder refers to them.
std::vector<std::string> seen_from(const std::filesystem::path& page, const std::filesystem::path& folder,
                                   std::vector<std::string> names)
{
    const auto from = std::filesystem::absolute(page).parent_path();
    for (std::string& name : names)
        name = std::filesystem::absolute(folder / name).lexically_relative(from).generic_string();
    return names;
}

void write_reports(const BenchOptions& options, const bench::Results& results, const bench::SurfaceResults& surface,
                   const bench::Announce& announce)
{
    if (!options.json.empty()) write_output(options.json, bench::json_report(results, surface));
    std::vector<std::string> plots;
    if (!options.plots.empty()) plots = bench::write_plots(results, options.plots);
    if (options.markdown.empty()) return;
    const bench::Baselines baselines = bench::measure_baselines(options.settings, announce);
    write_output(options.markdown,
                 bench::markdown_page(results, surface, baselines, seen_from(options.markdown, options.plots, plots),
                                      options.settings.field));
}

// Before hours of counting.
void announce_files(const BenchOptions& options)
{
    announce_outputs({options.json, options.markdown});
    std::vector<std::filesystem::path> plots;
    for (const std::string& core : bench::kCores)
        if (!options.plots.empty()) plots.push_back(std::filesystem::path(options.plots) / bench::plot_name(core));
    baker::announce_outputs(plots);
}

// A scene that cannot be read, or that an output would replace, is told now: fields that lie in the work folder already
// are not baked again, so that nothing else may read it before the outputs are written.
void read_scene(const std::filesystem::path& scene)
{
    std::vector<std::string> ignored;
    baker::load_scene(scene, {}, ignored);
}

// Chord fields are those of the bench's scene.
void keep_surface_modes(BenchOptions& options)
{
    options.settings.surface_file = options.field;
    std::vector<std::string>& modes = options.settings.matrix.modes;
    modes.erase(std::remove_if(modes.begin(), modes.end(), [](const auto& m) { return !bench::is_surface(m); }),
                modes.end());
    if (modes.empty()) throw UsageError("--field goes with modes of surface fields");
}

void run(BenchOptions& options)
{
    bench::Settings& settings = options.settings;
    settings.source = std::filesystem::absolute(options.source);
    settings.work = std::filesystem::absolute(options.work);
    settings.field.scene = options.scene.empty() ? settings.source / "baker" / "scenes" / "product.obj"
                                                 : std::filesystem::path(options.scene);
    if (!options.field.empty()) keep_surface_modes(options);
    announce_files(options);
    read_scene(settings.field.scene);
    const bench::Announce announce = [](const std::string& step) { std::fprintf(stderr, "%s\n", step.c_str()); };
    const bench::Results results = bench::measure(settings, announce);
    const bench::SurfaceResults surface = bench::measure_surface(settings, announce);
    std::fputs(bench::text_report(results, surface).c_str(), stdout);
    write_reports(options, results, surface, announce);
}

// A list of words, separated by commas.
void add_words(CLI::App& command, const std::string& name, std::vector<std::string>& value, const std::string& what)
{
    std::string words;
    for (const std::string& word : value) words += (words.empty() ? "" : ", ") + word;
    command.add_option(name, value, what + " [" + words + "]")
        ->delimiter(',')
        ->check(CLI::IsMember(value))
        ->type_name("LIST");
}

void add_matrix_options(CLI::App& command, BenchOptions& options)
{
    bench::Matrix& matrix = options.settings.matrix;
    command.add_flag_callback(
        "--quick", [&matrix] { matrix = bench::quick_matrix(); }, "A few rows only");
    add_words(command, "--core", matrix.cores, "Cores");
    const std::vector<std::string> surface_modes = bench::surface_mode_names();
    matrix.modes.insert(matrix.modes.end(), surface_modes.begin(), surface_modes.end());
    add_words(command, "--mode", matrix.modes, "Reconstructions of chord fields and modes of surface fields");
    add_words(command, "--texel", matrix.texels, "Texel formats of chord fields");
    add_words(command, "--pixel", matrix.pixels, "Pixels of surface fields");
    add_words(command, "--view", matrix.views, "Views");
    command.add_option("--span", matrix.spans, "Pixels between exact ones, 0 for the exact renderer [0, 4, 8, 16]")
        ->delimiter(',')
        ->check(CLI::IsMember(bench::kSpans))
        ->type_name("LIST");
}

void add_place_options(CLI::App& command, BenchOptions& options)
{
    command.add_option("--json", options.json, "Write the rows here as JSON")->type_name("FILE");
    command.add_option("--plot", options.plots, "Write plots of cost against accuracy here as SVG")->type_name("DIR");
    command.add_option("--markdown", options.markdown, "Write the whole page here; measures the baselines too")
        ->type_name("FILE");
    command.add_option("--work", options.work, "Folder for builds and fields, kept for the next run")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_option("--source", options.source, "The project's source tree")->type_name("DIR");
    command.add_option("--scene", options.scene, "Scene to bake [product.obj of the source tree]")->type_name("OBJ");
    command.add_option("--field", options.field, "A surface field to draw alone, in place of the scene's")
        ->type_name("FILE");
    bench::FieldSettings& field = options.settings.field;
    command.add_option("--origins", field.origins, "M of the baked field")->capture_default_str();
    command.add_option("--directions", field.directions, "N of the baked field")->capture_default_str();
    command.add_option("--spp", field.samples, "Light paths per texel")->capture_default_str();
}

}  // namespace

void add_bench(CLI::App& lumi)
{
    auto options = std::make_shared<BenchOptions>();
    CLI::App* command = lumi.add_subcommand(
        "bench", "Count what drawing costs on emulated microcontrollers, and how exact the pictures are");
    add_matrix_options(*command, *options);
    add_place_options(*command, *options);
    command->footer(
        "Needs cmake, ninja, the arm-none-eabi toolchain and qemu-system-arm in PATH.\n"
        "Example:\n  lumi bench --core m4,m0plus --mode linear --span 8,16 --json bench.json\n"
        "  lumi bench --field model.lumi --core m4,m0plus --view generic");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::tools
