// SPDX-License-Identifier: MIT
// Messages of `lumi bake`: what it chose, how far it is, what it wrote and what that is worth.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands/bake_options.h"
#include "terminal/progress_printer.h"

namespace lumi::tools
{

enum class BakeStep { planning, baking, measuring };

// Tells how far a bake is, over all of its steps, as the options ask: for people on stderr, for machines on stdout. It
// tells it again where a step reports nothing for a while.
class BakeProgress
{
public:
    using Clock = std::chrono::steady_clock;

    explicit BakeProgress(const BakeOptions& options);
    BakeProgress(const BakeProgress&) = delete;
    BakeProgress& operator=(const BakeProgress&) = delete;

    // The triangles of the scene, and the bytes that its field has at most.
    void expect(size_t triangles, uint64_t bytes);
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    // The seconds that each stage of the work took, by its name.
    std::vector<std::pair<std::string, double>> stages();

    // Calls work(progress).
    template <class Work>
    auto in(BakeStep step, Work work)
    {
        const Step open(*this, step);
        return work(baker::ProgressCallback([this](const baker::Progress& progress) { return tell(progress); }));
    }

private:
    struct Step {
        Step(BakeProgress& all, BakeStep step) : all_(all) { all.begin(step); }
        ~Step() { all_.end(); }
        BakeProgress& all_;
    };

    void begin(BakeStep step);
    void end();
    bool tell(const baker::Progress& progress);
    void print(const baker::Progress& whole);
    double tell_again();  // returns the seconds until the next time

    const BakeOptions& options_;
    const Clock::time_point start_ = Clock::now();
    std::mutex mutex_;  // guards what follows
    WholeTime time_;
    BakeStep step_ = BakeStep::planning;
    ProgressPrinter people_;
    std::optional<JsonProgress> machines_;
    std::map<baker::Stage, double> stage_seconds_;
    double told_ = 0;  // until when they count
    baker::Progress last_;
    std::optional<double> last_seconds_;  // nothing between steps
    std::optional<Teller> teller_;        // the last: it uses all else
};

// A bake that is done.
struct BakeSummary {
    const BakeOptions& options;
    const baker::Scene& scene;
    BakeProgress& progress;
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
