// SPDX-License-Identifier: MIT
// lumi bake: from a scene to a field file.
#include <memory>

#include "../planner/chord_plan.h"
#include "commands/bake_options.h"
#include "commands/bake_summary.h"
#include "commands/commands.h"
#include "commands/device_figures.h"
#include "commands/layout_trial.h"
#include "commands/pace_plan.h"
#include "commands/state_options.h"
#include "files/output_file.h"
#include "lumi/baker/file_guard.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

// Where a bake writes.
struct Output {
    std::string name;    // the field or the shard file, as the caller names it
    std::string target;  // the file behind the name; empty: only a plan is made
    std::optional<baker::Shard> shard;
};

std::optional<baker::Shard> shard_of(const std::string& text)
{
    if (text.empty()) return std::nullopt;
    const auto part = parse_part(text);
    if (!part)
        throw UsageError("--shard takes K/COUNT with K from 1 to COUNT, for instance 3/16, not \"" + text + "\"");
    return baker::Shard{part->part, part->count};
}

// model.lumi in the working folder for .../model.obj.
std::string field_name(const BakeOptions& options)
{
    if (!options.output.empty()) return options.output;
    // Before the name counts as one that is read and written.
    if (std::filesystem::path(options.scene.path).extension() == ".lumi")
        throw Failure(options.scene.path, "this is a field already", "draw it by 'lumi view' or 'lumi render'");
    return std::filesystem::path(options.scene.path).stem().string() + ".lumi";
}

Output output_of(const BakeOptions& options)
{
    Output output;
    output.shard = shard_of(options.shard);
    output.name = field_name(options);
    if (output.shard)
        output.name +=
            "." + std::to_string(output.shard->index) + "-of-" + std::to_string(output.shard->count) + ".shard";
    output.target = field_target(output.name);
    baker::announce_outputs(baker::working_files_of(output.target));
    return output;
}

// A chord field needs a stripe and little more, whatever its size.
void require_chord_ram(const BakeOptions& options)
{
    if (options.fit.ram.empty()) return;
    const uint64_t needed =
        host::chord_view_bytes(true) + uint64_t{host::stripe_pixel_bytes<PixelRgb565>(options.screen)};
    if (needed > options.fit.ram_bytes())
        throw Failure("--ram " + options.fit.ram,
                      "a view and a stripe of " + std::to_string(options.screen.stripe_rows()) + " rows take " +
                          std::to_string(needed) + " bytes",
                      "give more RAM, or fewer --rows");
}

// Throws Failure where no chord field fits.
baker::BakeSettings planned_chord(const BakeOptions& options)
{
    require_chord_ram(options);
    planner::ChordTask task;
    task.budget_bytes = options.fit.budget_bytes();
    task.settings = options.chord;
    task.origins_by_hand = options.has_origins;
    task.directions_by_hand = options.has_directions;
    if (!options.cap.empty())
        task.cap = [cap = options.cap](uint32_t origins) {
            const auto used = parse_cap(cap, origins);
            if (!used)
                throw baker::BakeError("--cap " + cap + " is no part of " + std::to_string(origins) + " origins");
            return *used;
        };
    try {
        return planner::plan_chord(task);
    } catch (const planner::NoPlan& none) {
        throw Failure("--fit " + options.fit.budget, none.what(), "give more flash, or set less by hand");
    }
}

class Bake
{
public:
    explicit Bake(const BakeOptions& options) : options_(options), progress_(options) {}

    void run()
    {
        if (!options_.fit.plan_only) output_ = output_of(options_);
        if (options_.layout == Layout::chord && !options_.fit.wanted())
            baker::field_file_bytes(options_.chord);  // throws before the scene is loaded
        const baker::Scene scene = load_scene(options_.scene, warnings_);
        progress_.expect(scene.triangle_count(), options_.limits.bytes);
        say_unplanned();
        const std::optional<baker::SurfacePlan> surface = surface_plan(scene);
        if (!surface) require_planned();
        const baker::BakeSettings chord = surface || !options_.fit.wanted() ? options_.chord : fitted_chord();
        if (options_.fit.plan_only) return;
        BakeSummary summary = {options_, scene, progress_, output_.name, output_.target, output_.shard.has_value()};
        surface ? bake(*surface, summary) : bake(chord, summary);
        summary.seconds = progress_.seconds();
        summary.warnings = warnings_;
        tell(summary);
        work_is_done();
    }

private:
    void say_unplanned() const
    {
        const char* option = options_.in_the_way_of_rate();
        if (options_.layout == Layout::chord || !options_.fit.has_rate() || option == nullptr) return;
        print(stderr,
              "lumi: with %s the rate of --for is only reported, not planned for; leave %s out to plan for it\n",
              option, option);
    }

    // A plan that was asked for must not stay away.
    void require_planned() const
    {
        if (options_.fit.wanted() || (!options_.fit.plan_only && options_.fit.json.empty())) return;
        throw Failure(options_.scene.path, kUnplannedChord, "give --fit, too, or --layout surface");
    }

    template <class Work>
    auto in_step(BakeStep step, Work work)
    {
        try {
            return progress_.in(step, work);
        } catch (const baker::Cancelled&) {
            throw_interrupted(output_.target);
        }
    }

    // Nothing where a chord field does the scene more justice and the user did not decide.
    std::optional<baker::SurfacePlan> surface_plan(const baker::Scene& scene)
    {
        const bool has_parts = !scene.moving_parts().empty();
        if (options_.layout == Layout::chord && has_parts)
            throw Failure(options_.scene.path, "a chord field has no parts that move",
                          "bake a surface field (--layout surface), or leave out the parts");
        require_other_light(scene, options_.scene.path);
        const bool has_states = !scene.light_states().empty();
        if (options_.layout == Layout::chord && has_states)
            throw Failure(options_.scene.path, "a chord field has no light states",
                          "bake a surface field (--layout surface), or leave out the states");
        if (has_states && output_.shard)
            throw Failure(options_.scene.path, "a field with light states is baked whole",
                          "leave out --shard, or the states");
        if (options_.layout == Layout::chord) return std::nullopt;
        if (options_.restart) baker::discard_stages(output_.target);
        baker::SurfacePlan plan = in_step(BakeStep::planning, [&](const baker::ProgressCallback& progress) {
            return baker::plan_surface(scene, options_.surface, options_.limits, progress, output_.target);
        });
        const bool is_asked_for = has_parts || has_states || options_.layout == Layout::surface;
        const bool takes = plan.mesh && (plan.against.empty() || is_asked_for || shows_more(scene, plan));
        if (!takes) baker::discard_stages(output_.target);
        if (!takes && is_asked_for) throw baker::BakeError(plan.against);
        // Where neither layout fits, the smaller of both sizes is the one to name.
        if (!takes && options_.fit.wanted()) planned_chord(options_);
        if (takes && options_.is_paced()) plan = paced(scene, plan);
        warnings_ += tell_plan(plan, options_, takes);
        if (!takes) return std::nullopt;
        if (!options_.fit.json.empty())
            write_output(options_.fit.json, plan_json(plan, options_.limits).dump(2) + "\n");
        return plan;
    }

    // The plan for the frame rate that is asked for.
    baker::SurfacePlan paced(const baker::Scene& scene, const baker::SurfacePlan& largest)
    {
        const std::vector<planner::Pace>& paces = options_.fit.paces;
        const PacePlan plan = in_step(BakeStep::planning, [&](const baker::ProgressCallback& progress) {
            return plan_for_pace(scene, largest, options_.limits, paces, options_.screen, progress);
        });
        if (options_.progress != ProgressStyle::json)
            print(options_.fit.plan_only ? stdout : stderr, "%s", text_of(plan, paces.front()).c_str());
        return plan.chosen.plan;
    }

    // Whether the surface field shows more of the scene than a chord field, by small bakes of both. The soft edge of a
    // volume is no fault of a mesh that a measure would find worse.
    bool shows_more(const baker::Scene& scene, baker::SurfacePlan& plan)
    {
        if (scene.mesh_is_shell()) return false;
        baker::BakeSettings chord = options_.chord;
        try {
            if (options_.fit.wanted()) chord = planned_chord(options_);
        } catch (const Failure&) {
            return true;  // a chord field does not fit
        }
        const LayoutTrial trial = in_step(BakeStep::planning, [&](const baker::ProgressCallback& progress) {
            return tried_layouts(scene, plan, chord, progress);
        });
        plan.against += formatted("; measured by small bakes, a surface field shows %.1f dB and a chord field %.1f dB",
                                  trial.surface_db, trial.chord_db);
        return trial.surface_db >= trial.chord_db;
    }

    baker::BakeSettings fitted_chord() const
    {
        const baker::BakeSettings plan = planned_chord(options_);
        tell_plan(plan, options_);
        if (!options_.fit.json.empty())
            write_output(options_.fit.json, plan_json(plan, options_.fit.budget_bytes()).dump(2) + "\n");
        return plan;
    }

    void bake(const baker::SurfacePlan& plan, BakeSummary& summary)
    {
        progress_.expect(summary.scene.triangle_count(), plan.most_bytes);
        summary.cap = static_cast<double>(plan.settings.cap);
        const baker::Progress last = traced([&](const baker::ProgressCallback& progress) {
            if (output_.shard)
                baker::bake_surface_shard(summary.scene, plan, *output_.shard, output_.target, progress, earlier());
            else
                summary.surface = baker::bake_surface(summary.scene, plan, output_.target, progress, earlier());
        });
        summary.rays = static_cast<double>(summary.surface ? summary.surface->paths : last.rays_total);
        summary.rays_saved = last.rays_saved;
    }

    void bake(const baker::BakeSettings& settings, BakeSummary& summary)
    {
        if (settings.used_origins != 0) summary.cap = static_cast<double>(settings.used_origins) / settings.origins;
        // Calls that may fail come before the field is written.
        const double rows = baker::shard_rows(settings, output_.shard.value_or(baker::Shard{}));
        const baker::Progress last = traced([&](const baker::ProgressCallback& progress) {
            if (output_.shard)
                baker::bake_shard(summary.scene, settings, *output_.shard, output_.target, progress, earlier());
            else
                baker::bake_field(summary.scene, settings, output_.target, progress, earlier());
        });
        summary.rays = rows * settings.directions * settings.samples;
        summary.rays_saved = last.rays_saved;
    }

    // The last report of the work.
    template <class Work>
    baker::Progress traced(Work work)
    {
        baker::Progress last;
        in_step(BakeStep::baking, [&](const baker::ProgressCallback& progress) {
            work([&](const baker::Progress& report) {
                last = report;
                return progress(report);
            });
        });
        return last;
    }

    baker::Earlier earlier() const { return options_.restart ? baker::Earlier::discard : baker::Earlier::resume; }

    const BakeOptions& options_;
    BakeProgress progress_;
    Output output_;
    size_t warnings_ = 0;
};

}  // namespace

void add_bake(CLI::App& lumi)
{
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command = lumi.add_subcommand("bake", "Path-trace a scene into a field file");
    add_bake_options(*command, *options);
    command->footer(
        "Without other options the field is a surface field of at most " + byte_text(options->limits.bytes) +
        ". An option that only\none layout has chooses that layout, except --paths. A chord field takes M x N x "
        "bytes\nper texel: " +
        byte_text(baker::field_file_bytes(options->chord)) +
        " with the defaults. A bake that was stopped, by Ctrl-C or otherwise,\ngoes on with the same command.\n"
        "Example:\n  lumi bake product.obj\n"
        "  lumi bake product.obj -o product.lumi --for rp2350@15fps\n"
        "  lumi bake product.obj -o product.lumi --fit 250kB --ram 40kB --screen 240x240 --rows 8\n"
        "  lumi bake product.obj -o product.lumi --layout chord --origins 512 --directions 1024 --spp 32");
    command->callback([options, command] {
        resolve(*command, *options);
        Bake(*options).run();
    });
}

}  // namespace lumi::tools
