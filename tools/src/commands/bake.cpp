// SPDX-License-Identifier: MIT
// lumi bake: from a scene to a field file.
#include <cstdio>
#include <memory>

#include "commands/bake_job.h"
#include "commands/bake_summary.h"
#include "commands/commands.h"
#include "commands/fit_options.h"
#include "commands/layout_options.h"
#include "commands/scene_options.h"
#include "commands/screen_options.h"
#include "commands/surface_choice.h"
#include "commands/surface_options.h"
#include "files/output_file.h"
#include "lumi/baker/file_guard.h"
#include "lumi/chord/texel.h"
#include "lumi/detail/lattice.h"
#include "program/choice.h"
#include "program/option_checks.h"
#include "program/option_group.h"
#include "terminal/failure.h"
#include "terminal/json_progress.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

enum class ProgressStyle { automatic, json };

// A byte a texel, the field that fits devices best.
baker::BakeSettings chord_defaults()
{
    baker::BakeSettings settings;
    settings.texel = TexelFormat::palette8;
    return settings;
}

struct BakeOptions {
    SceneOptions scene;
    baker::BakeSettings settings = chord_defaults();
    Layout layout = Layout::automatic;
    baker::SurfaceSettings surface;
    FitOptions fit;
    host::ScreenSize screen;
    std::string output, cap, shard;
    bool restart = false;
    ProgressStyle progress = ProgressStyle::automatic;
};

Choices<TexelFormat> texel_choices()
{
    Choices<TexelFormat> choices;
    for (const TexelFormat format : detail::AllTexels::kFormats)
        choices.push_back({detail::texel_name(format), format});
    return choices;
}
const Choices<TexelFormat> kTexelChoices = texel_choices();

baker::BakeSettings settings_of(const BakeOptions& options)
{
    baker::BakeSettings settings = options.settings;
    settings.threads = options.scene.threads;
    if (settings.footprint == baker::Footprint::point && settings.beam == baker::Beam::parallel)
        throw UsageError("--beam parallel needs --footprint origin or both: --footprint point is one ray");
    if (options.cap.empty()) return settings;
    const auto used = parse_cap(options.cap, settings.origins);
    if (!used)
        throw UsageError("--cap takes a number of origins from 2 to " + std::to_string(settings.origins) +
                         " or a share such as 50%, 0.5 or 100%, not \"" + options.cap + "\"");
    settings.used_origins = *used;
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

// model.lumi in the working folder for .../model.obj.
std::string output_of(const BakeOptions& options)
{
    if (!options.output.empty()) return options.output;
    // Before the name counts as one that is read and written.
    if (std::filesystem::path(options.scene.path).extension() == ".lumi")
        throw Failure(options.scene.path, "this is a field already", "draw it by 'lumi view' or 'lumi render'");
    return std::filesystem::path(options.scene.path).stem().string() + ".lumi";
}

BakeJob job_of(const BakeOptions& options)
{
    BakeJob job;
    job.settings = settings_of(options);
    job.shard = shard_of(options.shard);
    job.name = output_of(options);
    job.earlier = options.restart ? baker::Earlier::discard : baker::Earlier::resume;
    if (job.shard) job.name = shard_name(job.name, *job.shard);
    job.target = regular_target(job.name);
    announce_outputs({job.name});
    baker::announce_outputs(baker::working_files_of(job.target));
    return job;
}

// Without a size and with a mesh or texels by hand, what is left open has its default.
planner::SurfaceTask surface_task(const BakeOptions& options, const CLI::App& command, const std::string& target)
{
    const auto given = [&](const char* name) { return command.count(name) > 0; };
    planner::SurfaceTask task;
    task.output = target;
    task.settings = options.surface;
    task.settings.seed = options.settings.seed;
    task.settings.threads = options.scene.threads;
    if (const auto share = parse_cap_share(options.cap)) task.settings.cap = static_cast<float>(*share);
    const bool is_planned = options.fit.wanted() || (!given("--triangles") && !given("--texel-density"));
    if (options.fit.wanted()) task.budget_bytes = options.fit.budget_bytes();
    if (!is_planned) task.budget_bytes = UINT32_MAX;
    if (!options.fit.ram.empty()) task.ram = planner::RamLimit{options.fit.ram_bytes(), options.screen};
    task.triangles_by_hand = !is_planned || given("--triangles");
    task.density_by_hand = !is_planned || given("--texel-density");
    task.edge_by_hand = !is_planned || given("--longest-edge");
    return task;
}

class Bake
{
public:
    Bake(const BakeOptions& options, const CLI::App& command)
        : options_(options),
          command_(command),
          json_(options.progress == ProgressStyle::json),
          chord_(settings_of(options)),
          context_{command, chord_, options.cap, json_, options.screen}
    {
        check_fit(options.fit, context_);
    }

    void run()
    {
        BakeJob job;
        if (!options_.fit.plan_only) job = job_of(options_);
        if (options_.layout == Layout::chord && !options_.fit.wanted())
            baker::field_file_bytes(chord_);  // throws before the scene is loaded
        const BakeSummary::Clock::time_point start = BakeSummary::Clock::now();
        const baker::Scene scene = load_scene(options_.scene, warnings_);
        if (options_.layout == Layout::chord || !takes_surface(scene, job)) plan_chord(job);
        if (options_.fit.plan_only) return;
        const BakeSummary summary = {
            scene, job, warnings_, start, options_.fit.paces, screen(), options_.layout != Layout::chord};
        json_ ? bake_for_machines(summary) : bake_for_people(summary);
        work_is_done();
    }

private:
    // False where a chord field does the scene more justice and the user did not decide.
    bool takes_surface(const baker::Scene& scene, BakeJob& job)
    {
        const planner::SurfaceTask task = surface_task(options_, command_, job.target);
        if (options_.restart) baker::discard_stages(job.target);
        const SurfaceChoice choice = planned_choice(scene, task);
        const bool takes = choice.plan.draft && (choice.against.empty() || options_.layout == Layout::surface);
        if (!takes) baker::discard_stages(job.target);
        if (!choice.plan.draft && options_.layout == Layout::surface) throw baker::BakeError(choice.against);
        // Where neither layout fits, the smaller of both sizes is the one to name.
        if (!takes && options_.fit.wanted()) require_chord_fit(options_.fit, context_);
        warnings_ += tell_choice(choice, task, takes, json_);
        if (!takes) return false;
        write_plan(options_.fit, task, choice.plan);
        job.surface = choice.plan.settings;
        job.draft = choice.plan.draft;
        return true;
    }

    SurfaceChoice planned_choice(const baker::Scene& scene, const planner::SurfaceTask& task) const
    {
        if (json_) {
            JsonProgress printer(stdout, "planning");
            return surface_choice(scene, task, watch(printer));
        }
        ProgressPrinter printer(stderr, stderr_is_terminal(), step_text(BakeStep::planning, steps()));
        return surface_choice(scene, task, watch(printer));
    }

    std::optional<host::ScreenSize> screen() const
    {
        if (command_.count("--screen") == 0 && command_.count("--rows") == 0) return std::nullopt;
        return options_.screen;
    }

    int steps() const { return options_.fit.plan_only ? 1 : options_.shard.empty() ? 3 : 2; }

    void plan_chord(BakeJob& job) const
    {
        job.settings = options_.fit.wanted() ? fitted_chord(options_.fit, context_) : chord_;
    }

    const BakeOptions& options_;
    const CLI::App& command_;
    const bool json_;
    const baker::BakeSettings chord_;
    const FitContext context_;
    size_t warnings_ = 0;
};

void add_work_options(CLI::App& command, BakeOptions& options)
{
    const OptionGroup group(command, "Work");
    add_thread_option(command, options.scene);
    command.add_option("--seed", options.settings.seed, "Seed of the random numbers")
        ->type_name("K")
        ->check(whole_number(0, UINT64_MAX))
        ->capture_default_str();
    command
        .add_option("--shard", options.shard,
                    "Bake part K of COUNT only, into FIELD.lumi.K-of-COUNT.shard; `lumi merge` joins the parts")
        ->type_name("K/COUNT");
    command.add_flag("--restart", options.restart, "Discard the checkpoint of an earlier bake instead of going on");
    add_choice<ProgressStyle>(command, "--progress", options.progress,
                              {{"auto", ProgressStyle::automatic}, {"json", ProgressStyle::json}},
                              "auto: a bar, or lines where no terminal is; json: a line of JSON a second on stdout "
                              "[auto]");
}

void add_field_options(CLI::App& command, BakeOptions& options)
{
    const OptionGroup group(command, "Field");
    command
        .add_option("-o,--output", options.output,
                    "Field file to write [the scene's name, .lumi, in the working folder]")
        ->type_name("FIELD.lumi");
    add_layout_option(command, options.layout);
    command
        .add_option("--cap", options.cap,
                    "Bake what eyes in the uppermost part of the sphere see: a share such as 50% or 0.5, or for chord "
                    "fields a number of origins from 2 on; from below, the object is then not seen, or only a part of "
                    "it [all]")
        ->type_name("F");
    add_fit_options(command, options.fit);
    add_screen_options(command, options.screen);
}

void add_chord_options(CLI::App& command, BakeOptions& options)
{
    const OptionGroup group(command, "Chord fields");
    baker::BakeSettings& settings = options.settings;
    const auto sizes = whole_number(1, detail::kMaxLatticeSize);
    command.add_option("--origins", settings.origins, "chord: points on the near side of the sphere, M")
        ->type_name("M")
        ->check(sizes)
        ->capture_default_str();
    command.add_option("--directions", settings.directions, "chord: points on the far side, N")
        ->type_name("N")
        ->check(sizes)
        ->capture_default_str();
    add_choice(command, "--texel", settings.texel, kTexelChoices, "chord: what a ray is stored as [palette8]");
    add_choice<baker::Footprint>(
        command, "--footprint", settings.footprint,
        {{"point", baker::Footprint::point}, {"origin", baker::Footprint::origin}, {"both", baker::Footprint::both}},
        "chord: what a texel is the mean of: one ray, rays from all over the origin's cell, or also to "
        "all over the direction's [origin]");
    add_choice<baker::Beam>(command, "--beam", settings.beam,
                            {{"converging", baker::Beam::converging}, {"parallel", baker::Beam::parallel}},
                            "chord: how a texel's rays lie: all meet in the direction's point, or all have the "
                            "direction from point to point, as the LumiPath paper's [converging]");
    command.add_option("--spp", settings.samples, "chord: light paths per texel, at most; more cost time, never bytes")
        ->type_name("S")
        ->check(whole_number(1, kMostPaths))
        ->capture_default_str();
    command
        .add_option(
            "--adaptive", settings.max_error_levels,
            "chord: end a texel before --spp paths, from 16 on, once its standard error is below this many steps of "
            "255; 0: never")
        ->type_name("LEVELS")
        ->check(number(0, 255))
        ->capture_default_str();
}

}  // namespace

void add_bake(CLI::App& lumi)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = lumi.add_subcommand("bake", "Path-trace a scene into a field file");
    add_scene_options(*command, options->scene);
    add_field_options(*command, *options);
    add_surface_options(*command, options->surface);
    add_chord_options(*command, *options);
    add_work_options(*command, *options);
    command->footer(
        "Without other options the field is a surface field of at most " +
        byte_text(planner::SurfaceTask().budget_bytes) +
        ". An option that only\none layout has chooses that layout, except --paths. A chord field takes M x N x "
        "bytes\nper texel: " +
        byte_text(baker::field_file_bytes(chord_defaults())) +
        " with the defaults. A bake that was stopped, by Ctrl-C or otherwise,\ngoes on with the same command.\n"
        "Example:\n  lumi bake product.obj\n"
        "  lumi bake product.obj -o product.lumi --fit 1MB --for rp2350@15fps\n"
        "  lumi bake product.obj -o product.lumi --fit 250kB --ram 40kB --screen 240x240 --rows 8\n"
        "  lumi bake product.obj -o product.lumi --layout chord --origins 512 --directions 1024 --spp 32");
    command->callback([options, command] {
        options->layout = resolved_layout(*command, options->layout);
        options->scene.solid_volume = options->layout != Layout::chord;
        Bake(*options, *command).run();
    });
}

}  // namespace lumi::tools
