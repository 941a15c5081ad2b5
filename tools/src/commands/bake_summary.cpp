// SPDX-License-Identifier: MIT
#include "commands/bake_summary.h"

#include <cstdio>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "../quality/quick_check.h"
#include "commands/device_figures.h"
#include "commands/surface_options.h"
#include "files/field_file.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"
#include "terminal/json_progress.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

double seconds_since(BakeSummary::Clock::time_point start)
{
    return std::chrono::duration<double>(BakeSummary::Clock::now() - start).count();
}

void print_json(const nlohmann::json& line)
{
    std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

double cap_of(const BakeJob& job)
{
    if (job.surface) return static_cast<double>(job.surface->cap);
    const uint32_t all = job.settings.origins, used = job.settings.used_origins;
    return used == 0 ? 1 : static_cast<double>(used) / all;
}

// What the field shows; nothing where it is not to be judged.
std::optional<double> checked_db(const BakeSummary& summary, const baker::ProgressCallback& progress)
{
    if (!summary.checks || summary.job.shard) return std::nullopt;
    const unsigned threads = summary.job.surface ? summary.job.surface->threads : summary.job.settings.threads;
    try {
        const FieldFile field(summary.job.target, FieldFile::Role::own_output);
        return quality::quick_psnr_db(summary.scene, field, cap_of(summary.job), threads, progress);
    } catch (const baker::Cancelled&) {
        return std::nullopt;  // the field is there, and that is what counts
    }
}

std::string file_line(const BakeSummary& summary, const BakeOutcome& outcome)
{
    const double saved = static_cast<double>(outcome.last.rays_saved);
    const std::string savings = saved > 0 ? " (" + count_text(saved) + " of them saved)" : "";
    return summary.job.name + ": " + byte_text(std::filesystem::file_size(summary.job.target)) + ", " +
           count_text(outcome.rays) + " rays" + savings + " in " + duration_text(seconds_since(summary.start)) + ", " +
           std::to_string(summary.warnings) + (summary.warnings == 1 ? " warning\n" : " warnings\n");
}

std::string check_line(double psnr_db)
{
    char text[120];
    std::snprintf(text, sizeof text, "shows about %.1f dB in %d path-traced views, 240 x 240 pixels\n", psnr_db,
                  quality::kQuickViews);
    return text;
}

std::string next_line(const std::string& field)
{
    const std::string picture = std::filesystem::path(field).stem().string() + ".png";
    return "next: lumi render " + shell_word(field) + " -o " + shell_word(picture) + " --turntable 12\n";
}

void warn_of_written(const BakeSummary& summary, const char* problem)
{
    std::fprintf(stderr,
                 "lumi: warning: %s is written and whole, but what it shows cannot be said (%s); `lumi inspect` and "
                 "`lumi report` say it\n",
                 summary.job.name.c_str(), problem);
}

// What fails once the field is written costs its report, not the bake.
template <class Tell>
void tell_of_written(const BakeSummary& summary, Tell tell)
{
    try {
        tell();
    } catch (const std::bad_alloc&) {
        warn_of_written(summary, "memory does not suffice");
    } catch (const Failure& error) {
        warn_of_written(summary, error.what());
    }
}

std::optional<double> checked_db_for_people(const BakeSummary& summary)
{
    ProgressPrinter printer(stderr, stderr_is_terminal(), step_text(BakeStep::measuring, summary.steps()));
    return checked_db(summary, watch(printer));
}

// A chord field draws as fast as any of its size: it is told where it was asked.
std::string device_lines(const BakeSummary& summary, const BakeOutcome& outcome)
{
    const bool has_screen = summary.screen.has_value();
    if (summary.job.shard || !(outcome.surface || has_screen || !summary.paces.empty())) return "";
    const FieldFile field(summary.job.target, FieldFile::Role::own_output);
    const host::ScreenSize screen = summary.screen.value_or(host::ScreenSize());
    std::string text = outcome.surface || has_screen ? device_text(field, {screen, {}}) : "";
    for (const planner::Pace& pace : summary.paces) text += pace_text(field, pace, screen);
    return text;
}

void tell_people(const BakeSummary& summary, const BakeOutcome& outcome)
{
    std::string text = file_line(summary, outcome);
    if (outcome.surface) text += surface_text(*outcome.surface);
    if (const auto psnr_db = checked_db_for_people(summary)) text += check_line(*psnr_db);
    text += device_lines(summary, outcome);
    if (summary.checks && !summary.job.shard) text += next_line(summary.job.name);
    std::fputs(text.c_str(), stdout);
}

void tell_machines(const BakeSummary& summary, const BakeOutcome& outcome)
{
    nlohmann::json line = {{"state", "done"},
                           {"output", summary.job.name},
                           {"layout", outcome.surface ? "surface" : "chord"},
                           {"bytes", std::filesystem::file_size(summary.job.target)},
                           {"rays_total", outcome.rays},
                           {"rays_saved", outcome.last.rays_saved},
                           {"elapsed_seconds", seconds_since(summary.start)},
                           {"warnings", summary.warnings}};
    if (outcome.surface) line["surface"] = surface_json(*outcome.surface);
    JsonProgress printer(stdout, "measuring");
    if (const auto psnr_db = checked_db(summary, watch(printer))) line["quick_psnr_db"] = *psnr_db;
    print_json(line);
}

// How a bake of this task gets more triangles than the plan has.
std::string more_triangles(const planner::SurfaceTask& task, uint32_t planned)
{
    if (task.triangles_by_hand || planned >= planner::kMostPlannedTriangles)
        return "give more --triangles than " + std::to_string(planned);
    return "give more bytes, which buy triangles: --fit " + std::to_string(2 * task.budget_bytes / 1000) + "kB";
}

std::string text_of(const baker::MeshWarning& warning, const std::string& more)
{
    const bool has_both = !warning.remedy.empty() && warning.more_triangles_help;
    const std::string remedies = warning.remedy + (has_both ? ", or " : "") + (warning.more_triangles_help ? more : "");
    return warning.problem + (remedies.empty() ? "" : "; " + remedies);
}

std::vector<std::string> warnings_of(const SurfaceChoice& choice, const planner::SurfaceTask& task)
{
    const std::string more = more_triangles(task, choice.plan.settings.triangles);
    std::vector<std::string> warnings;
    for (const baker::MeshWarning& warning : choice.plan.draft->warnings()) warnings.push_back(text_of(warning, more));
    if (!choice.against.empty()) warnings.push_back(choice.against + "; --layout chord shows all of it");
    return warnings;
}

}  // namespace

std::string step_text(BakeStep step, int steps)
{
    if (steps == 1) return "";
    constexpr const char* kNames[] = {"planning", "baking", "measuring"};
    const auto k = static_cast<size_t>(step);
    return std::to_string(k + 1) + " of " + std::to_string(steps) + " " + kNames[k] + ": ";
}

size_t tell_choice(const SurfaceChoice& choice, const planner::SurfaceTask& task, bool takes_surface, bool json)
{
    if (json) {
        nlohmann::json line = {{"state", "planned"}, {"layout", takes_surface ? "surface" : "chord"}};
        if (!choice.against.empty()) line["reason"] = choice.against;
        if (takes_surface) line["options"] = options_of(choice.plan);
        if (takes_surface && choice.plan.ram_bytes != 0) {
            line["ram_bytes"] = choice.plan.ram_bytes;
            line["triangles_without_ram"] = choice.plan.triangles_without_ram;
        }
        print_json(line);
    } else if (takes_surface) {
        const std::string ram = ram_text(choice.plan);
        std::printf("layout surface: %s\n%s  by hand: %s\n", text_of(choice.plan).c_str(),
                    ram.empty() ? "" : ("  " + ram + "\n").c_str(), options_of(choice.plan).c_str());
    } else {
        std::printf("layout chord: %s\n", choice.against.c_str());
    }
    std::fflush(stdout);
    const std::vector<std::string> warnings = takes_surface ? warnings_of(choice, task) : std::vector<std::string>{};
    for (const std::string& warning : warnings) std::fprintf(stderr, "lumi: warning: %s\n", visible(warning).c_str());
    return warnings.size();
}

void bake_for_people(const BakeSummary& summary)
{
    BakeOutcome outcome;
    {
        ProgressPrinter printer(stderr, stderr_is_terminal(), step_text(BakeStep::baking, summary.steps()));
        outcome = run_job(summary.scene, summary.job, watch(printer));
    }
    tell_of_written(summary, [&] { tell_people(summary, outcome); });
}

void bake_for_machines(const BakeSummary& summary)
{
    JsonProgress printer(stdout);
    const BakeOutcome outcome = run_job(summary.scene, summary.job, watch(printer));
    tell_of_written(summary, [&] { tell_machines(summary, outcome); });
}

}  // namespace lumi::tools
