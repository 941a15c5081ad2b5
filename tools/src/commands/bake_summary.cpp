// SPDX-License-Identifier: MIT
#include "commands/bake_summary.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>

#include "../planner/chord_plan.h"
#include "../quality/measured.h"
#include "commands/device_figures.h"
#include "files/field_file.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

void print_json(const nlohmann::json& line)
{
    print(stdout, "%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

// Whether the field was planned by its mesh, and is judged by a few path-traced views.
bool is_checked(const BakeSummary& summary)
{
    return summary.options.layout != Layout::chord && !summary.is_shard;
}

// Measuring a field that is written must not fail its bake. Takes what the machine refuses: threads and memory.
template <class Measure>
auto unless_refused(const BakeSummary& summary, const Measure& measure) -> decltype(measure())
{
    std::string reason;
    try {
        return measure();
    } catch (const baker::BakeError& refusal) {
        reason = refusal.what();
    } catch (const std::system_error& refusal) {
        reason = std::string(refusal.what()) + "; `lumi report` measures it";
    } catch (const std::bad_alloc&) {
        reason = "there is too little memory; `lumi report` measures it";
    }
    print(stderr, "lumi: warning: %s: it is written, but not measured: %s\n", summary.name.c_str(), reason.c_str());
    return {};
}

// The PSNR of the field; nothing where it is not to be judged.
std::optional<double> checked_db(const BakeSummary& summary)
{
    if (!is_checked(summary)) return std::nullopt;
    try {
        return summary.progress.in(
            BakeStep::measuring,
            [&](const baker::ProgressCallback& progress) {
                const FieldFile field(summary.file, FieldFile::Role::own_output);
                return quality::quick_psnr_db(summary.scene, field, summary.cap, summary.options.scene.threads,
                                              progress);
            });
    } catch (const baker::Cancelled&) {
        return std::nullopt;  // the field is there, and that is what counts
    }
}

// One word for it, and the number: "good likeness (36.4 dB)".
std::string likeness_text(double psnr_db)
{
    constexpr double kExcellent = 40, kGood = 34, kFair = 28;
    const char* const word = psnr_db >= kExcellent ? "excellent"
                             : psnr_db >= kGood    ? "good"
                             : psnr_db >= kFair    ? "fair"
                                                   : "poor";
    return formatted("%s likeness (%.1f dB)", word, psnr_db);
}

std::string file_and_size(const BakeSummary& summary)
{
    return summary.name + ": " + byte_text(std::filesystem::file_size(summary.file)) + ", ";
}

// "product.lumi: 498 kB, 3:07": begins with file_and_size(), which the likeness follows.
std::string file_line(const BakeSummary& summary)
{
    std::string text = file_and_size(summary) + duration_text(summary.seconds);
    if (const auto saved = static_cast<double>(summary.rays_saved); saved > 0)
        text += ", " + count_text(saved) + " of " + count_text(summary.rays) + " light paths saved";
    if (summary.warnings != 0)
        text += ", " + std::to_string(summary.warnings) + (summary.warnings == 1 ? " warning" : " warnings");
    return text + "\n";
}

// Says where the mesh is not the object; nothing where nobody would see it.
std::string surface_line(const baker::SurfaceBake& bake)
{
    constexpr double kSeen = 0.01;
    const double wrong = bake.loss.missed + bake.loss.displaced;
    if (wrong < kSeen) return "";
    return formatted("%.0f %% of the object is missing or out of place: it is finer than the field's %u triangles\n",
                     100 * wrong, bake.triangles);
}

std::string notes_of(const baker::SurfaceBake& bake)
{
    std::string text;
    for (const std::string& note : bake.notes) text += visible(note) + "\n";
    return text;
}

// "160 kB suffice, 500 kB were allowed; --fill uses them all"
std::string suffices_line(const BakeSummary& summary)
{
    const uint64_t allowed = summary.options.limits.bytes;
    if (!summary.surface->suffices || allowed == UINT32_MAX) return "";
    return byte_text(std::filesystem::file_size(summary.file)) + " suffice, " + byte_text(allowed) +
           " were allowed; --fill uses them all\n";
}

nlohmann::json surface_json(const baker::SurfaceBake& bake)
{
    return {{"triangles", bake.triangles},     {"vertices", bake.vertices},  {"viewed_vertices", bake.viewed_vertices},
            {"texels", bake.texels},           {"missed", bake.loss.missed}, {"added", bake.loss.added},
            {"displaced", bake.loss.displaced}};
}

std::string next_line(const std::string& field)
{
    const std::string picture = std::filesystem::path(field).stem().string() + ".png";
    return "next: lumi render " + shell_word(field) + " -o " + shell_word(picture) + " --turntable 12\n";
}

// A line for each part that was asked for, else for an RP2040.
std::string device_lines(const BakeSummary& summary)
{
    if (summary.is_shard) return "";
    const Waiting waiting("drawing poses to time them");
    const FieldFile field(summary.file, FieldFile::Role::own_output);
    std::vector<planner::Pace> paces = summary.options.fit.paces;
    if (paces.empty()) paces = {planner::parse_pace("rp2040").value()};
    std::string text;
    for (const planner::Pace& pace : paces) text += pace_text(field, pace, summary.options.screen);
    return text;
}

// "mesh 7.1 s, light 31.0 s, solving 18.3 s, measuring 1.2 s"
std::string stages_line(const BakeSummary& summary)
{
    std::string text;
    for (const auto& [name, seconds] : summary.progress.stages())
        text += formatted("%s%s %.1f s", text.empty() ? "" : ", ", name.c_str(), seconds);
    return text + "\n";
}

void tell_people(const BakeSummary& summary)
{
    std::string text = file_line(summary);
    if (summary.surface) text += surface_line(*summary.surface) + notes_of(*summary.surface) + suffices_line(summary);
    if (const auto psnr_db = unless_refused(summary, [&] { return checked_db(summary); }))
        text.insert(file_and_size(summary).size(), likeness_text(*psnr_db) + ", ");
    if (summary.options.surface.draft) text += "a draft: bake it without --draft to ship it\n";
    if (summary.options.verbose) text += stages_line(summary);
    text += unless_refused(summary, [&] { return device_lines(summary); });
    if (is_checked(summary)) text += next_line(summary.name);
    print(stdout, "%s", text.c_str());
}

void tell_machines(const BakeSummary& summary)
{
    nlohmann::json line = {{"state", "done"},
                           {"output", summary.name},
                           {"layout", summary.surface ? "surface" : "chord"},
                           {"bytes", std::filesystem::file_size(summary.file)},
                           {"rays_total", summary.rays},
                           {"rays_saved", summary.rays_saved},
                           {"elapsed_seconds", summary.seconds},
                           {"warnings", summary.warnings}};
    if (summary.surface) line["surface"] = surface_json(*summary.surface);
    if (const auto psnr_db = unless_refused(summary, [&] { return checked_db(summary); }))
        line["quick_psnr_db"] = *psnr_db;
    for (const auto& [name, seconds] : summary.progress.stages()) line["stage_seconds"][name] = seconds;
    print_json(line);
}

// The options of `lumi bake` that set the same by hand.
std::string options_of(const baker::SurfacePlan& plan)
{
    const baker::SurfaceSettings& s = plan.settings;
    std::string options =
        formatted("--layout surface --triangles %u --longest-edge %.6g --texel-density %.6g", s.triangles,
                  static_cast<double>(s.longest_edge), static_cast<double>(s.texels_per_radius));
    if (s.cap < 1) options += formatted(" --cap %.6g%%", 100 * static_cast<double>(s.cap));
    if (s.fills) options += " --fill";
    if (s.finest_texels != baker::SurfaceSettings().finest_texels) {
        const long side = std::lround(s.finest_texels / baker::kFinestTexelsASide);
        options += formatted(" --screen %ldx%ld", side, side);
    }
    if (s.ground) options += " --ground";
    if (s.gloss_maps != baker::SurfaceSettings().gloss_maps) options += formatted(" --gloss-maps %u", s.gloss_maps);
    return s.view_tables ? options : options + " --no-view-tables";
}

// Says what a mesh of the plan lacks for a limit of RAM, such as "fewer triangles than 3684"; may be empty.
std::string lacks_of(const baker::SurfacePlan& plan)
{
    std::string text;
    if (plan.triangles_without_ram != 0) text = "fewer triangles than " + std::to_string(plan.triangles_without_ram);
    if (plan.fewer_maps) {
        const uint32_t maps = plan.settings.gloss_maps;
        if (!text.empty()) text += ", and ";
        text += maps == 0 ? "no gloss maps"
                          : "at most " + std::to_string(maps) + (maps == 1 ? " gloss map" : " gloss maps");
    }
    return text;
}

// "39.8 kB of RAM, for which it has fewer triangles than 3684"; empty where the plan has no limit of RAM.
std::string ram_text(const baker::SurfacePlan& plan)
{
    if (plan.ram_bytes == 0) return "";
    const std::string lacks = lacks_of(plan);
    return byte_text(plan.ram_bytes) + " of RAM, for which " +
           (lacks.empty() ? "nothing is given up" : "it has " + lacks);
}

// "5500 triangles, 93.4 texels a radius, at most 499 kB".
std::string text_of(const baker::SurfacePlan& plan)
{
    return formatted("%u triangles, %.1f texels a radius, at most %s", plan.triangles,
                     static_cast<double>(plan.settings.texels_per_radius), byte_text(plan.most_bytes).c_str());
}

// How a bake within these limits gets more triangles than the plan has.
std::string more_triangles(const BakeOptions& options, uint32_t planned)
{
    const baker::SurfaceLimits& limits = options.limits;
    if (options.is_paced()) return "ask for a lower rate, which leaves time for triangles";
    if (!limits.chooses_triangles || planned >= baker::kMostPlannedTriangles)
        return "give more --triangles than " + std::to_string(planned);
    return "give more bytes, which buy triangles: --fit " + std::to_string(2 * limits.bytes / 1000) + "kB";
}

std::string text_of(const baker::MeshWarning& warning, const std::string& more)
{
    const bool has_both = !warning.remedy.empty() && warning.more_triangles_help;
    const std::string remedies = warning.remedy + (has_both ? ", or " : "") + (warning.more_triangles_help ? more : "");
    return warning.problem + (remedies.empty() ? "" : "; " + remedies);
}

// How many bytes a surface field needs; `unknown` where nobody knows.
std::string enough_text(const baker::SurfacePlan& plan, const char* unknown)
{
    if (plan.enough_bytes == 0) return unknown;
    return "; a surface field that shows all of it takes about " + byte_text(plan.enough_bytes) + ": --fit " +
           std::to_string(plan.enough_bytes / 1000) + "kB";
}

std::vector<std::string> warnings_of(const baker::SurfacePlan& plan, const BakeOptions& options)
{
    const std::string more = more_triangles(options, plan.settings.triangles);
    std::vector<std::string> warnings;
    for (const baker::MeshWarning& warning : plan.warnings) warnings.push_back(text_of(warning, more));
    if (!plan.against.empty()) warnings.push_back(plan.against + enough_text(plan, "; --layout chord shows all of it"));
    return warnings;
}

// A machine with two idle cores does so much, in light paths a second or work that takes as long. It decides how evenly
// a bake's share moves until its light shows a pace.
constexpr double kUsualPace = 3e5;
constexpr double kMeasuredPaths = 1e6, kMeasuredAtOnce = 3;  // and how many times faster than a bake's they are
constexpr double kSilentSeconds = 1.5, kTellsAgainSeconds = 0.5;

}  // namespace

BakeProgress::BakeProgress(const BakeOptions& options)
    : options_(options), time_({0, 0, 0}), people_(stderr, stderr_is_terminal())
{
    teller_.emplace(
        mutex_, kTellsAgainSeconds, [this] { return tell_again(); });
}

void BakeProgress::expect(size_t triangles, uint64_t bytes)
{
    constexpr double kMeshWork = 9, kLeastMesh = 5e5;                             // of a triangle, of any scene
    constexpr double kTexelBytes = 1.5, kMostTexels = 1 << 20, kOtherPaths = 70;  // of a texel, besides --paths
    const double texels = std::min(static_cast<double>(bytes) / kTexelBytes, kMostTexels);
    const double paths = kOtherPaths + options_.surface.paths_per_texel;
    const bool bakes = !options_.fit.plan_only, measures = bakes && options_.shard.empty();
    const std::lock_guard<std::mutex> lock(mutex_);
    time_.expect(0, (kLeastMesh + kMeshWork * static_cast<double>(triangles)) / kUsualPace);
    time_.expect(1, bakes ? texels * paths / kUsualPace : 0);
    time_.expect(2, measures ? kMeasuredPaths / kMeasuredAtOnce / kUsualPace : 0);
}

void BakeProgress::begin(BakeStep step)
{
    constexpr const char* kNames[] = {"planning", "baking", "measuring"};
    const std::lock_guard<std::mutex> lock(mutex_);
    time_.begin(static_cast<size_t>(step));
    step_ = step;
    if (options_.progress == ProgressStyle::json) machines_.emplace(stdout, kNames[static_cast<size_t>(step)]);
}

void BakeProgress::end()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    last_seconds_.reset();
    people_.clear();
}

bool BakeProgress::tell(const baker::Progress& progress)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const double now = seconds();
    if (progress.rays_per_second > 0 && options_.shard.empty())
        time_.expect(2, kMeasuredPaths / kMeasuredAtOnce / progress.rays_per_second);
    baker::Progress own = progress;
    // The work before the light has a share of its own, which says nothing of the whole.
    if (step_ == BakeStep::baking && progress.eta_seconds < 0) own.rays_done = 0;
    last_ = time_.of(own, now);
    last_.rays_done = progress.rays_done;
    if (step_ == BakeStep::measuring) last_.stage = baker::Stage::measuring;
    last_seconds_ = now;
    stage_seconds_[last_.stage] += now - told_;
    told_ = now;
    print(last_);
    return !interrupt_flag().load(std::memory_order_relaxed);
}

std::vector<std::pair<std::string, double>> BakeProgress::stages()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::pair<std::string, double>> result;
    for (const auto& [stage, taken] : stage_seconds_) result.emplace_back(stage_name(stage), taken);
    return result;
}

void BakeProgress::print(const baker::Progress& whole)
{
    machines_ ? machines_->print(whole) : people_.print(whole);
}

double BakeProgress::tell_again()
{
    const double now = seconds();
    if (last_seconds_ && now - *last_seconds_ >= kSilentSeconds) {
        baker::Progress later = last_;
        later.elapsed_seconds = now;
        later.rays_per_second = 0;
        if (later.eta_seconds >= 0) later.eta_seconds = std::max(0.0, last_.eta_seconds - (now - *last_seconds_));
        print(later);
    }
    return kTellsAgainSeconds;
}

size_t tell_plan(const baker::SurfacePlan& plan, const BakeOptions& options, bool takes_surface)
{
    if (options.progress == ProgressStyle::json) {
        nlohmann::json line = {{"state", "planned"}, {"layout", takes_surface ? "surface" : "chord"}};
        if (!plan.against.empty()) line["reason"] = plan.against;
        if (takes_surface) line["options"] = options_of(plan);
        if (takes_surface && plan.ram_bytes != 0) {
            line["ram_bytes"] = plan.ram_bytes;
            line["triangles_without_ram"] = plan.triangles_without_ram;
            line["fewer_maps"] = plan.fewer_maps;
        }
        print_json(line);
    } else if (takes_surface) {
        const std::string ram = ram_text(plan);
        if (options.fit.plan_only)
            print(stdout, "layout surface: %s\n%s  by hand: %s\n", text_of(plan).c_str(),
                  ram.empty() ? "" : ("  " + ram + "\n").c_str(), options_of(plan).c_str());
        else if (!lacks_of(plan).empty())
            print(stderr, "lumi: it takes %s\n", ram.c_str());
    } else {
        print(options.fit.plan_only ? stdout : stderr, "%slayout chord: %s\n",
              options.fit.plan_only ? "" : "lumi: ", (plan.against + enough_text(plan, "")).c_str());
    }
    std::fflush(stdout);
    const std::vector<std::string> warnings = takes_surface ? warnings_of(plan, options) : std::vector<std::string>{};
    for (const std::string& warning : warnings) print(stderr, "lumi: warning: %s\n", warning.c_str());
    return warnings.size();
}

void tell_plan(const baker::BakeSettings& chord, const BakeOptions& options)
{
    const std::string by_hand = planner::options_of(chord);
    if (options.progress == ProgressStyle::json)
        print_json({{"layout", "chord"}, {"options", by_hand}, {"state", "planned"}});
    else if (options.fit.plan_only)
        print(stdout, "layout chord: %s\n  by hand: %s\n", planner::text_of(chord).c_str(), by_hand.c_str());
    std::fflush(stdout);
}

nlohmann::json plan_json(const baker::SurfacePlan& plan, const baker::SurfaceLimits& limits)
{
    nlohmann::json json = {{"budget_bytes", limits.bytes}, {"layout", "surface"},
                           {"options", options_of(plan)},  {"most_bytes", plan.most_bytes},
                           {"triangles", plan.triangles},  {"texels_per_radius", plan.settings.texels_per_radius},
                           {"missed", plan.loss.missed}};
    if (limits.ram)
        json.update({{"ram_bytes", plan.ram_bytes},
                     {"triangles_without_ram", plan.triangles_without_ram},
                     {"fewer_maps", plan.fewer_maps}});
    return json;
}

nlohmann::json plan_json(const baker::BakeSettings& chord, uint64_t budget_bytes)
{
    return {{"layout", "chord"},
            {"options", planner::options_of(chord)},
            {"budget_bytes", budget_bytes},
            {"bytes", baker::field_file_bytes(chord)}};
}

// A failure after the field is written costs its report, not the bake.
void tell(const BakeSummary& summary)
{
    const auto warn = [&](const char* problem) {
        print(stderr,
              "lumi: warning: %s is written and whole, but what it shows cannot be said (%s); `lumi inspect` "
              "and `lumi report` say it\n",
              summary.name.c_str(), problem);
    };
    try {
        summary.options.progress == ProgressStyle::json ? tell_machines(summary) : tell_people(summary);
    } catch (const std::bad_alloc&) {
        warn("memory does not suffice");
    } catch (const Failure& error) {
        warn(error.what());
    }
}

void throw_interrupted(const std::string& output)
{
    const std::filesystem::path part = output + ".part", stages = baker::kept_stages(output);
    for (const std::filesystem::path& kept : {part, stages})
        if (!output.empty() && std::filesystem::exists(kept))
            throw Interrupted(kept.string() + " keeps what is done (" + byte_text(std::filesystem::file_size(kept)) +
                              "); the same command goes on from there");
    throw Interrupted();
}

}  // namespace lumi::tools
