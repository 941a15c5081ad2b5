// SPDX-License-Identifier: MIT
#include "commands/bake_options.h"

#include <algorithm>
#include <array>

#include "commands/camera_options.h"
#include "commands/part_options.h"
#include "commands/state_options.h"
#include "files/output_file.h"
#include "lumi/chord/texel.h"
#include "lumi/detail/lattice.h"
#include "lumi/surface/format.h"
#include "program/option_checks.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

constexpr std::array kChordOnly = {"--origins", "--directions", "--texel",   "--footprint",
                                   "--beam",    "--spp",        "--adaptive"};
constexpr std::array kSurfaceShape = {"--triangles",      "--longest-edge", "--texel-density",
                                      "--no-view-tables", "--ground",       "--draft"};
// A draft chooses these.
constexpr std::array kOfDraft = {"--fit", "--fill", "--triangles", "--longest-edge", "--texel-density", "--paths"};
// Only surface fields take these, but they say nothing of the layout: a scene may still suit only the other one.
constexpr std::array kSurfaceOther = {"--paths", "--fill", "--gloss-maps"};

// The first of them that was given; null if none was.
template <class Names>
const char* first_given(const CLI::App& command, const Names& names)
{
    for (const char* name : names)
        if (command.count(name) != 0) return name;
    return nullptr;
}

// A number of origins; a share suits both layouts.
bool is_chord_cap(const CLI::App& command)
{
    return command.count("--cap") != 0 &&
           command.get_option("--cap")->as<std::string>().find_first_of(".%") == std::string::npos;
}

void refuse(const char* option, const std::string& layout)
{
    if (option != nullptr) throw UsageError(std::string(option) + " does not go with --layout " + layout);
}

Layout resolved_layout(const CLI::App& command, Layout layout)
{
    const char* chord = is_chord_cap(command) ? "--cap with a number of origins" : first_given(command, kChordOnly);
    const char* shape = first_given(command, kSurfaceShape);
    const char* surface = shape != nullptr ? shape : first_given(command, kSurfaceOther);
    if (layout == Layout::chord) refuse(surface, "chord");
    if (layout == Layout::surface) refuse(chord, "surface");
    if (layout != Layout::automatic) return layout;
    if (chord != nullptr && surface != nullptr)
        throw UsageError(std::string(chord) + " belongs to chord fields, " + surface +
                         " to surface fields; leave one of them out");
    return chord != nullptr ? Layout::chord : shape != nullptr ? Layout::surface : Layout::automatic;
}

baker::BakeSettings chord_of(const BakeOptions& options)
{
    baker::BakeSettings settings = options.chord;
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

void check_unfitted(const CLI::App& command, const BakeOptions& options)
{
    if (command.count("--ram") > 0) throw UsageError("--ram belongs to --fit");
    for (const char* name : {"--plan-only", "--plan"}) {
        if (command.count(name) == 0) continue;
        if (!options.fit.has_rate()) throw UsageError(std::string(name) + " belongs to --fit");
        if (options.layout == Layout::chord)
            throw UsageError(std::string(name) + " needs --fit here: " + kUnplannedChord);
    }
}

void check_fit(const CLI::App& command, const FitOptions& options)
{
    if (command.count("--shard") > 0 && (options.wanted() || options.has_rate()))
        throw UsageError(std::string("--shard does not go with ") + (options.wanted() ? "--fit" : "--for and a rate") +
                         "; shard the plan it finds");
    if (options.wanted()) options.budget_bytes();
    if (!options.ram.empty()) options.ram_bytes();
    announce_outputs({options.json});
}

// Without a size and with a mesh or texels by hand, what is left open has its default.
baker::SurfaceLimits limits_of(const CLI::App& command, const BakeOptions& options)
{
    const auto given = [&](const char* name) { return command.count(name) > 0; };
    const bool is_planned =
        options.fit.wanted() || (!options.surface.draft && !given("--triangles") && !given("--texel-density"));
    baker::SurfaceLimits limits;
    if (options.fit.wanted()) limits.bytes = options.fit.budget_bytes();
    if (!is_planned) limits.bytes = UINT32_MAX;
    for (const planner::Pace& pace : options.fit.paces)
        if (pace.is_asked && pace.chip->flash_bytes != 0)
            limits.bytes = std::min<uint64_t>(limits.bytes, pace.chip->flash_bytes);
    if (!options.fit.ram.empty()) limits.ram = baker::RamLimit{options.fit.ram_bytes(), options.screen};
    limits.chooses_triangles = is_planned && !given("--triangles");
    limits.chooses_density = is_planned && !given("--texel-density");
    limits.chooses_edge = is_planned && !given("--longest-edge");
    return limits;
}

// Reads the size that the option `name` has as `text`.
uint64_t size_of(const std::string& name, const std::string& text, const std::string& examples)
{
    const auto bytes = parse_bytes(text);
    if (!bytes || *bytes == 0 || *bytes > UINT32_MAX)
        throw UsageError(name + " takes a size below 4 GB such as " + examples + ", not \"" + text + "\"");
    return *bytes;
}

void add_fit_options(CLI::App& command, FitOptions& options)
{
    command
        .add_option(
            "--fit", options.budget,
            "Choose all parameters that are not set by hand so that the file takes at most this: 2MB, 512KiB, 1500000")
        ->type_name("SIZE");
    command
        .add_option("--ram", options.ram,
                    "fit: so few gloss maps and so coarse a mesh that view and stripe take at most so much RAM, "
                    "antialiased on --screen: 40kB")
        ->type_name("SIZE");
    add_pace_option(command, options.paces,
                    "with a rate: choose triangles, texels, view tables and mode that show most at it; else say the "
                    "mode and its rate; rp2040x2 stands for both cores",
                    true);
    command.add_flag("--plan-only", options.plan_only, "fit: end with the plan, without a bake");
    command.add_option("--plan", options.json, "fit: write the plan here as JSON")->type_name("FILE");
}

void add_field_options(CLI::App& command, BakeOptions& options)
{
    const OptionGroup group(command, "Field");
    command
        .add_option("-o,--output", options.output,
                    "Field file to write [the scene's name, .lumi, in the working folder]")
        ->type_name("FIELD.lumi");
    add_choice<Layout>(
        command, "--layout", options.layout,
        {{"auto", Layout::automatic}, {"surface", Layout::surface}, {"chord", Layout::chord}},
        "surface: a mesh that carries colours, by far the best for solid objects; chord: the paper's, for all scenes; "
        "auto: surface, unless a mesh does not do the scene justice [auto]");
    command
        .add_option("--cap", options.cap,
                    "Bake what eyes in the uppermost part of the sphere see: a share such as 50% or 0.5, or for chord "
                    "fields a number of origins from 2 on; from below, the object is then not seen, or only a part of "
                    "it [all]")
        ->type_name("F");
    add_fit_options(command, options.fit);
    add_screen_options(command, options.screen);
    command.get_option("--screen")
        ->description("Screen of the device, for RAM, frame rates and how fine texels are at most [240x240]");
}

void add_surface_options(CLI::App& command, baker::SurfaceSettings& s)
{
    const OptionGroup group(command, "Surface fields");
    command.add_option("--triangles", s.triangles, "surface: triangles of the mesh, before long edges are split")
        ->type_name("T")
        ->check(whole_number(1, 2 * detail::format::kMaxPatches))
        ->capture_default_str();
    command.add_option("--longest-edge", s.longest_edge, "surface: longer edges of the mesh are split, in radii")
        ->type_name("R")
        ->check(number(0.02, 2))
        ->capture_default_str();
    command
        .add_option("--texel-density", s.texels_per_radius,
                    "surface: texels along a line of one radius, in the mean; fewer where they show as much")
        ->type_name("D")
        ->check(number(1, 4096))
        ->capture_default_str();
    command.add_flag_callback(
        "--no-view-tables", [&s] { s.view_tables = false; },
        "surface: colours that do not depend on the direction of view: fewer bytes, no gloss");
    command
        .add_option("--gloss-maps", s.gloss_maps,
                    "surface: at most so many gloss maps, for highlights with edges; each takes RAM and time a frame")
        ->type_name("N")
        ->check(whole_number(0, detail::format::kMaxGlossMaps))
        ->capture_default_str();
    command.add_flag(
        "--ground", s.ground,
        "surface: add a soft shadow below the object, on a level ground that is not drawn; firmware without "
        "see-through patches leaves it out");
    command.add_flag(
        "--draft", s.draft,
        "surface: a first look in some ten seconds, coarse, noisy and without gloss maps; the file says so");
    command.add_flag("--fill", s.fills, "surface: use all triangles and texels that fit, though fewer show as much");
    command.add_option("--paths", s.paths_per_texel, "surface: light paths a texel; more cost time, never bytes")
        ->type_name("P")
        ->check(whole_number(1, kMostPaths))
        ->capture_default_str();
}

Choices<TexelFormat> texel_choices()
{
    Choices<TexelFormat> choices;
    for (const TexelFormat format : detail::AllTexels::kFormats)
        choices.push_back({detail::texel_name(format), format});
    return choices;
}
const Choices<TexelFormat> kTexelChoices = texel_choices();

// A first look within some ten seconds on two cores.
void set_draft(const CLI::App& command, BakeOptions& options)
{
    if (const char* chosen = first_given(command, kOfDraft))
        throw UsageError(std::string("--draft chooses ") + chosen + " itself; leave one of them out");
    baker::SurfaceSettings& s = options.surface;
    s.triangles = 2000;
    s.longest_edge = 0.4f;
    s.texels_per_radius = 40;
    s.paths_per_texel = 4;
}

void add_chord_options(CLI::App& command, BakeOptions& options)
{
    const OptionGroup group(command, "Chord fields");
    baker::BakeSettings& settings = options.chord;
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

void add_work_options(CLI::App& command, BakeOptions& options)
{
    const OptionGroup group(command, "Work");
    add_thread_option(command, options.scene);
    command.add_option("--seed", options.chord.seed, "Seed of the random numbers")
        ->type_name("K")
        ->check(whole_number(0, UINT64_MAX))
        ->capture_default_str();
    command
        .add_option("--shard", options.shard,
                    "Bake part K of COUNT only, into FIELD.lumi.K-of-COUNT.shard; `lumi merge` joins the parts")
        ->type_name("K/COUNT");
    command.add_flag("--verbose", options.verbose, "Say at the end how many seconds each stage took");
    command.add_flag("--restart", options.restart, "Discard the checkpoint of an earlier bake instead of going on");
    add_choice<ProgressStyle>(command, "--progress", options.progress,
                              {{"auto", ProgressStyle::automatic}, {"json", ProgressStyle::json}},
                              "auto: a bar, or lines where no terminal is; json: a line of JSON a second on stdout "
                              "[auto]");
}

}  // namespace

BakeOptions::BakeOptions()
{
    chord.texel = TexelFormat::palette8;
}

bool BakeOptions::is_paced() const
{
    return fit.has_rate() && in_the_way_of_rate() == nullptr;
}

const char* BakeOptions::in_the_way_of_rate() const
{
    if (limits.ram) return "--ram";
    if (surface.draft) return "--draft";
    if (!limits.chooses_triangles) return "--triangles";
    return limits.chooses_density ? nullptr : "--texel-density";
}

bool FitOptions::has_rate() const
{
    return std::any_of(
        paces.begin(), paces.end(), [](const planner::Pace& pace) { return pace.is_asked; });
}

uint64_t FitOptions::budget_bytes() const
{
    return size_of("--fit", budget, "2MB, 512KiB or 1500000");
}

uint64_t FitOptions::ram_bytes() const
{
    return size_of("--ram", ram, "40kB, 64KiB or 20000");
}

void add_bake_options(CLI::App& command, BakeOptions& options)
{
    add_scene_options(command, options.scene);
    add_part_option(command, options.scene.parts, PartWords::motion);
    add_state_option(command, options.scene.states, StateWords::names);
    add_tint_option(command, options.scene.tints);
    add_field_options(command, options);
    add_surface_options(command, options.surface);
    add_chord_options(command, options);
    add_work_options(command, options);
}

void resolve(const CLI::App& command, BakeOptions& options)
{
    options.layout = resolved_layout(command, options.layout);
    options.scene.solid_volume = options.layout != Layout::chord;
    options.chord = chord_of(options);
    options.has_origins = command.count("--origins") > 0;
    options.has_directions = command.count("--directions") > 0;
    options.has_screen = command.count("--screen") + command.count("--rows") > 0;
    if (!options.fit.wanted()) check_unfitted(command, options);
    check_fit(command, options.fit);
    if (options.surface.draft) set_draft(command, options);
    options.limits = limits_of(command, options);
    options.surface.seed = options.chord.seed;
    options.surface.threads = options.scene.threads;
    options.surface.finest_texels =
        baker::kFinestTexelsASide * static_cast<float>(std::min(options.screen.width_px, options.screen.height_px));
    if (const auto share = parse_cap_share(options.cap)) options.surface.cap = static_cast<float>(*share);
}

}  // namespace lumi::tools
