// SPDX-License-Identifier: MIT
// lumi bake: from a scene to a field file.
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/choice.h"
#include "commands/commands.h"
#include "commands/fit_options.h"
#include "commands/layout_options.h"
#include "commands/scene_options.h"
#include "commands/surface_options.h"
#include "files/output_file.h"
#include "lumi/baker/bake.h"
#include "lumi/baker/file_guard.h"
#include "lumi/lattice.h"
#include "terminal/failure.h"
#include "terminal/json_progress.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

enum class ProgressStyle { automatic, json };

struct BakeOptions {
    SceneOptions scene;
    baker::BakeSettings settings;
    Layout layout = Layout::automatic;
    baker::SurfaceSettings surface;
    FitOptions fit;
    std::string output, cap, shard;
    bool restart = false;
    ProgressStyle progress = ProgressStyle::automatic;
};

// What is baked, and where to.
struct BakeJob {
    baker::BakeSettings settings;
    std::optional<baker::SurfaceSettings> surface;  // in place of them
    std::optional<baker::Shard> shard;
    std::string name;    // of the field, or of the shard file, as the caller says it
    std::string target;  // the file behind the name
    baker::Earlier earlier;
};

const Choices<format::TexelFormat> kTexelChoices = {{"rgb888", format::TexelFormat::rgb888},
                                                    {"rgb565", format::TexelFormat::rgb565},
                                                    {"palette8", format::TexelFormat::palette8},
                                                    {"luma8", format::TexelFormat::luma8}};

baker::BakeSettings settings_of(const BakeOptions& options)
{
    baker::BakeSettings settings = options.settings;
    settings.threads = options.scene.threads;
    if (options.cap.empty()) return settings;
    const auto used = parse_cap(options.cap, settings.origins);
    if (!used)
        throw UsageError("--cap takes a number of origins from 1 to " + std::to_string(settings.origins) +
                         " or a share such as 50% or 0.5, not \"" + options.cap + "\"");
    settings.used_origins = *used;
    return settings;
}

std::optional<baker::SurfaceSettings> surface_of(const BakeOptions& options)
{
    if (options.layout == Layout::chord) return std::nullopt;
    baker::SurfaceSettings settings = options.surface;
    settings.seed = options.settings.seed;
    settings.threads = options.scene.threads;
    return settings;
}

std::optional<baker::Shard> shard_of(const std::string& text)
{
    if (text.empty()) return std::nullopt;
    const auto part = parse_part(text);
    if (!part)
        throw UsageError("--shard takes K/COUNT with K from 1 to COUNT, for instance 3/16, not \"" + text + "\"");
    return baker::Shard{part->part, part->count};
}

std::string shard_name(const std::string& field, const baker::Shard& shard)
{
    return field + "." + std::to_string(shard.index) + "-of-" + std::to_string(shard.count) + ".shard";
}

BakeJob job_of(const BakeOptions& options)
{
    BakeJob job = {settings_of(options),
                   surface_of(options),
                   shard_of(options.shard),
                   options.output,
                   {},
                   options.restart ? baker::Earlier::discard : baker::Earlier::resume};
    if (job.shard) job.name = shard_name(options.output, *job.shard);
    job.target = regular_target(job.name);
    announce_outputs({job.name});
    baker::announce_outputs(baker::working_files_of(job.target));
    return job;
}

struct Outcome {
    baker::Progress last;
    std::optional<baker::SurfaceBake> surface;
};

Outcome bake(const baker::Scene& scene, const BakeJob& job, const baker::ProgressCallback& progress)
{
    Outcome outcome;
    const auto note = [&](const baker::Progress& report) {
        outcome.last = report;
        return progress(report);
    };
    try {
        if (job.surface && job.shard)
            baker::bake_surface_shard(scene, *job.surface, *job.shard, job.target, note, job.earlier);
        else if (job.surface)
            outcome.surface = baker::bake_surface(scene, *job.surface, job.target, note, job.earlier);
        else if (job.shard)
            baker::bake_shard(scene, job.settings, *job.shard, job.target, note, job.earlier);
        else
            baker::bake_field(scene, job.settings, job.target, note, job.earlier);
        return outcome;
    } catch (const baker::Cancelled&) {
        throw Interrupted(job.name + ".part keeps the finished rows; the same command goes on from there");
    }
}

double rays_of(const BakeJob& job, const baker::Progress& last)
{
    if (job.surface) return static_cast<double>(last.rays_total);
    const double rows = baker::shard_rows(job.settings, job.shard.value_or(baker::Shard{}));
    return rows * job.settings.directions * job.settings.samples;
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// For people: a bar or lines on stderr, a summary on stdout.
void bake_for_people(const baker::Scene& scene, const BakeJob& job, size_t warnings, Clock::time_point start)
{
    Outcome outcome;
    {
        ProgressPrinter printer(stderr, stderr_is_terminal());
        outcome = bake(scene, job, watch(printer));
    }
    const baker::Progress& last = outcome.last;
    const std::string elapsed = duration_text(seconds_since(start));
    const double saved = static_cast<double>(last.rays_saved);
    const std::string savings = saved > 0 ? " (" + count_text(saved) + " of them saved)" : "";
    std::printf("%s: %s, %s rays%s in %s, %zu warnings\n", job.name.c_str(),
                byte_text(std::filesystem::file_size(job.target)).c_str(), count_text(rays_of(job, last)).c_str(),
                savings.c_str(), elapsed.c_str(), warnings);
    if (outcome.surface) std::printf("%s", surface_text(*outcome.surface).c_str());
}

// For machines: nothing but JSON lines on stdout.
void bake_for_machines(const baker::Scene& scene, const BakeJob& job, size_t warnings, Clock::time_point start)
{
    JsonProgress printer(stdout);
    const Outcome outcome = bake(scene, job, watch(printer));
    const baker::Progress& last = outcome.last;
    nlohmann::json line = {{"state", "done"},
                           {"output", job.name},
                           {"bytes", std::filesystem::file_size(job.target)},
                           {"rays_total", rays_of(job, last)},
                           {"rays_saved", last.rays_saved},
                           {"elapsed_seconds", seconds_since(start)},
                           {"warnings", warnings}};
    if (outcome.surface) line["surface"] = surface_json(*outcome.surface);
    std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void take_plan(const planner::Plan& plan, BakeJob& job)
{
    job.settings = plan.chord;
}

void run(const BakeOptions& options, const CLI::App& command)
{
    const Clock::time_point start = Clock::now();
    const bool json = options.progress == ProgressStyle::json;
    const baker::BakeSettings common = settings_of(options);
    const FitContext context = {command, common, options.cap, json};
    check_fit(options.fit, context);
    size_t warnings = 0;
    if (options.fit.plan_only) {
        fitted_plan(options.fit, context, load_scene(options.scene, warnings));
        return;
    }
    BakeJob job = job_of(options);
    if (!job.surface && !options.fit.wanted())
        baker::field_file_bytes(job.settings);  // throws before the scene is loaded
    const baker::Scene scene = load_scene(options.scene, warnings);
    if (options.fit.wanted()) take_plan(fitted_plan(options.fit, context, scene), job);
    (json ? bake_for_machines : bake_for_people)(scene, job, warnings, start);
}

void add_scale_options(CLI::App& command, BakeOptions& options)
{
    command
        .add_option("--shard", options.shard,
                    "Bake part K of COUNT only, into FIELD.lumi.K-of-COUNT.shard; `lumi merge` joins the parts")
        ->type_name("K/COUNT");
    command.add_flag("--restart", options.restart, "Discard the checkpoint of an earlier bake instead of going on");
    add_choice<ProgressStyle>(command, "--progress", options.progress,
                              {{"auto", ProgressStyle::automatic}, {"json", ProgressStyle::json}}, "auto|json",
                              "auto: a bar, or lines where no terminal is; json: a line of JSON a second on stdout "
                              "[auto]");
}

void add_lattice_options(CLI::App& command, BakeOptions& options)
{
    baker::BakeSettings& settings = options.settings;
    const auto sizes = CLI::Range(uint32_t{1}, kMaxLatticeSize);
    command.add_option("--origins", settings.origins, "Points on the near side of the sphere, M")
        ->type_name("M")
        ->check(sizes)
        ->capture_default_str();
    command.add_option("--directions", settings.directions, "Points on the far side, N")
        ->type_name("N")
        ->check(sizes)
        ->capture_default_str();
    command
        .add_option("--cap", options.cap,
                    "Bake the uppermost origins only: a number of them, or a share such as 50% or 0.5; from below the "
                    "object is then not seen [all]")
        ->type_name("F");
    add_choice(command, "--texel", settings.texel, kTexelChoices, "FORMAT",
               "What a ray is stored as: rgb888 (3 bytes), rgb565 (2), palette8 or luma8 (1) [rgb565]");
    add_choice<baker::Footprint>(
        command, "--footprint", settings.footprint,
        {{"point", baker::Footprint::point}, {"origin", baker::Footprint::origin}, {"both", baker::Footprint::both}},
        "point|origin|both",
        "What a texel is the mean of: one ray, rays from all over the origin's cell, or also to "
        "all over the direction's [origin]");
}

}  // namespace

void add_bake(CLI::App& lumi)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = lumi.add_subcommand("bake", "Path-trace a scene into a field file");
    add_scene_options(*command, options->scene);
    command->add_option("-o,--output", options->output, "Field file to write")->type_name("FIELD.lumi");
    add_lattice_options(*command, *options);
    add_layout_option(*command, options->layout);
    add_surface_options(*command, options->surface);
    command
        ->add_option("--spp", options->settings.samples, "Light paths per texel, at most; more cost time, never bytes")
        ->type_name("S")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command
        ->add_option("--adaptive", options->settings.max_error_levels,
                     "End a texel before --spp paths, from 16 on, once its standard error is below this many steps of "
                     "255; 0: never")
        ->type_name("LEVELS")
        ->check(CLI::Range(0.0f, 255.0f))
        ->capture_default_str();
    command->add_option("--seed", options->settings.seed, "Seed of the random numbers")
        ->type_name("K")
        ->capture_default_str();
    add_fit_options(*command, options->fit);
    add_scale_options(*command, *options);
    command->footer(
        "The file takes M x N x bytes per texel: " + byte_text(baker::field_file_bytes({})) +
        " with the defaults.\nA bake that was stopped, by Ctrl-C or otherwise, goes on with the same command.\n"
        "Example:\n  lumi bake product.obj -o product.lumi --fit 1MB --for rp2350@15fps\n"
        "  lumi bake product.obj -o product.lumi --origins 512 --directions 1024 --spp 32");
    command->callback([options, command] {
        if (options->output.empty() && !options->fit.plan_only) throw UsageError("bake takes -o, --output FIELD.lumi");
        options->layout = resolved_layout(*command, options->layout);
        run(*options, *command);
    });
}

}  // namespace lumi::tools
