// SPDX-License-Identifier: MIT
// Messages of `lumi bake`: what it chose, how far it is, what it wrote and what that is worth.
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands/bake_options.h"
#include "terminal/progress_printer.h"

namespace lumi::tools
{

enum class BakeStep { planning, baking, measuring };

// The words that progress begins with in a bake of these options: "2 of 3 baking: "; nothing where there is one step.
std::string step_text(BakeStep step, const BakeOptions& options);
const char* name_of(BakeStep step);

// Calls work(progress), whose progress is told as the options ask: for people on stderr, for machines on stdout.
template <class Work>
auto with_progress(BakeStep step, const BakeOptions& options, Work work)
{
    if (options.progress == ProgressStyle::json) {
        JsonProgress printer(stdout, name_of(step));
        return work(watch(printer));
    }
    ProgressPrinter printer(stderr, stderr_is_terminal(), step_text(step, options));
    return work(watch(printer));
}

// A bake that is done.
struct BakeSummary {
    using Clock = std::chrono::steady_clock;

    const BakeOptions& options;
    const baker::Scene& scene;
    std::string name, file;  // as the caller names it, and the file behind the name
    bool is_shard = false;
    double cap = 1;                                            // share of the sphere that eyes may look from
    std::optional<baker::SurfaceBake> surface = std::nullopt;  // a whole surface field has it
    double rays = 0;                                           // light paths that the field was made of
    uint64_t rays_saved = 0;
    double seconds = 0;
    size_t warnings = 0;
};

// Tells machines and --plan-only the layout, its reason and its figures, before the bake. Of a bake itself people are
// told on stderr why it is a chord field, what RAM takes from it, and what a surface will not show. Returns how many
// warnings that were.
size_t tell_plan(const baker::SurfacePlan& plan, const BakeOptions& options, bool takes_surface);
void tell_plan(const baker::BakeSettings& chord, const BakeOptions& options);
// The text that --plan writes.
nlohmann::json plan_json(const baker::SurfacePlan& plan, const baker::SurfaceLimits& limits);
nlohmann::json plan_json(const baker::BakeSettings& chord, uint64_t budget_bytes);

// Prints a summary on stdout: a text for people, a JSON line for machines.
void tell(const BakeSummary& summary);

// Throws Interrupted, telling what is kept of a bake of `output`.
[[noreturn]] void throw_interrupted(const std::string& output);

}  // namespace lumi::tools
