// SPDX-License-Identifier: MIT
#include "commands/ladder.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "../planner/chord_plan.h"
#include "commands/bake_summary.h"
#include "commands/scene_options.h"
#include "files/field_file.h"
#include "lumi/baker/surface.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

struct Rung {
    bool is_surface;
    const char* size;  // as --fit takes it
    uint64_t bytes;
};

constexpr Rung kRungs[] = {{true, "60kB", 60'000},   {true, "120kB", 120'000},  {true, "250kB", 250'000},
                           {true, "500kB", 500'000}, {false, "250kB", 250'000}, {false, "1MB", 1'000'000},
                           {false, "4MB", 4'000'000}};
constexpr Rung kQuickRungs[] = {
    {true, "120kB", 120'000}, {true, "250kB", 250'000}, {true, "500kB", 500'000}, {false, "1MB", 1'000'000}};

// Light paths a texel, and a ray of a chord field.
struct Paths {
    uint32_t surface, chord;
};
constexpr Paths kPaths = {100, 16}, kQuickPaths = {12, 4};

// Whether what the cache holds is such a field of the scene; else it is baked anew.
bool is_kept(const std::string& path, const Rung& rung, const baker::Scene& scene)
{
    try {
        const FieldFile file(path, FieldFile::Role::own_output);
        file.require_intact();
        return file.is_surface() == rung.is_surface && file.size() <= rung.bytes && has_sphere_of(file, scene);
    } catch (const Failure&) {
        return false;
    }
}

class LadderBake
{
public:
    LadderBake(const baker::Scene& scene, const LadderSettings& settings) : scene_(scene), settings_(settings) {}

    void add(const Rung& rung, const std::string& step)
    {
        const Paths paths = settings_.is_quick ? kQuickPaths : kPaths;
        const char* const layout = rung.is_surface ? "surface" : "chord";
        const uint32_t count = rung.is_surface ? paths.surface : paths.chord;
        const std::string name = std::string(layout) + "-" + rung.size + "-" + std::to_string(count) + "paths.lumi";
        const std::string file = (std::filesystem::path(settings_.folder) / name).string();
        if (!is_kept(file, rung, scene_) &&
            !(rung.is_surface ? bakes_surface(rung, count, file, step) : bakes_chord(rung, count, file, step)))
            return;
        ladder_.fields.push_back(file);
        ladder_.bakes[file] = settings_.scene_words + "--layout " + layout + " --fit " + rung.size;
    }

    Ladder taken() { return std::move(ladder_); }

private:
    bool bakes_surface(const Rung& rung, uint32_t paths, const std::string& file, const std::string& step)
    {
        baker::SurfaceSettings settings;
        settings.paths_per_texel = paths;
        settings.threads = settings_.threads;
        baker::SurfaceLimits limits;
        limits.bytes = rung.bytes;
        baker::SurfacePlan plan;
        in_step(file, step + "planning: ", [&](const baker::ProgressCallback& progress) {
            plan = baker::plan_surface(scene_, settings, limits, progress, file);
        });
        if (!plan.mesh) {
            print(stderr, "no surface field of %s: %s\n", rung.size, plan.against.c_str());
            return false;
        }
        in_step(file, step + "baking: ", [&](const baker::ProgressCallback& progress) {
            baker::bake_surface(scene_, plan, file, progress);
        });
        return true;
    }

    bool bakes_chord(const Rung& rung, uint32_t paths, const std::string& file, const std::string& step)
    {
        planner::ChordTask task;
        task.budget_bytes = rung.bytes;
        task.settings.texel = TexelFormat::palette8;
        task.settings.samples = paths;
        task.settings.threads = settings_.threads;
        const baker::BakeSettings plan = planner::plan_chord(task);
        in_step(file, step + "baking: ", [&](const baker::ProgressCallback& progress) {
            baker::bake_field(scene_, plan, file, progress);
        });
        return true;
    }

    template <class Work>
    static void in_step(const std::string& file, const std::string& step, Work work)
    {
        try {
            ProgressPrinter printer(stderr, stderr_is_terminal(), step);
            work(watch(printer));
        } catch (const baker::Cancelled&) {
            throw_interrupted(file);
        }
    }

    const baker::Scene& scene_;
    const LadderSettings& settings_;
    Ladder ladder_;
};

std::vector<Rung> rungs_of(const baker::Scene& scene, bool is_quick)
{
    std::vector<Rung> rungs = is_quick ? std::vector<Rung>(std::begin(kQuickRungs), std::end(kQuickRungs))
                                       : std::vector<Rung>(std::begin(kRungs), std::end(kRungs));
    const auto is_chord = [](const Rung& rung) { return !rung.is_surface; };
    if (!scene.moving_parts().empty() || !scene.light_states().empty())
        rungs.erase(std::remove_if(rungs.begin(), rungs.end(), is_chord), rungs.end());
    return rungs;
}

}  // namespace

Ladder baked_ladder(const baker::Scene& scene, const LadderSettings& settings)
{
    const std::vector<Rung> rungs = rungs_of(scene, settings.is_quick);
    std::error_code ignored;  // the bake tells it where that fails
    std::filesystem::create_directories(settings.folder, ignored);
    LadderBake bake(scene, settings);
    for (size_t k = 0; k < rungs.size(); ++k)
        bake.add(rungs[k], "field " + std::to_string(k + 1) + " of " + std::to_string(rungs.size()) + ", ");
    return bake.taken();
}

}  // namespace lumi::tools
