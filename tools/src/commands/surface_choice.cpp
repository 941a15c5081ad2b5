// SPDX-License-Identifier: MIT
#include "commands/surface_choice.h"

#include <cstdio>

#include "../planner/no_plan.h"
#include "commands/bake_job.h"
#include "lumi/baker/bake.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

std::string reason(const planner::SurfacePlan& plan, bool of_volume)
{
    const baker::MeshLoss& loss = plan.draft->loss();
    const bool lacks_leaves = loss.missed_see_through > kMostMissedOfVolume;
    const double limit = of_volume || lacks_leaves ? kMostMissedOfVolume : kMostMissed,
                 wrong = loss.added + loss.displaced;
    char text[200];
    if (lacks_leaves || loss.missed - loss.missed_see_through > limit) {
        std::snprintf(text, sizeof text,
                      "of the light paths that meet the scene %.1f %% miss a mesh of %u triangles (limit %.0f %%), "
                      "%.1f %% meet it elsewhere",
                      100 * loss.missed, plan.draft->triangles(), 100 * limit, 100 * loss.displaced);
        return text;
    }
    if (of_volume || wrong <= kMostWrong) return "";
    std::snprintf(text, sizeof text,
                  "for 100 light paths that meet the scene %.1f meet a mesh of %u triangles where the scene is not "
                  "(limit %.0f)",
                  100 * wrong, plan.draft->triangles(), 100 * kMostWrong);
    return text;
}

}  // namespace

SurfaceChoice surface_choice(const baker::Scene& scene, const planner::SurfaceTask& task,
                             const baker::ProgressCallback& progress)
{
    try {
        planner::SurfacePlan plan = planner::plan_surface(scene, task, progress);
        if (plan.draft->triangles() == 0) return {{}, "no light path meets a surface"};
        return {plan, reason(plan, scene.mesh_is_shell())};
    } catch (const planner::NoPlan& none) {
        return {{}, none.what()};
    } catch (const baker::BakeError& error) {
        return {{}, error.what()};
    } catch (const baker::Cancelled&) {
        throw_interrupted(task.output.string());
    }
}

std::string ram_text(const planner::SurfacePlan& plan)
{
    if (plan.ram_bytes == 0) return "";
    const std::string given_up = plan.triangles_without_ram == 0 ? ", for which nothing is given up"
                                                                 : ", for which it has fewer triangles than " +
                                                                       std::to_string(plan.triangles_without_ram);
    return byte_text(plan.ram_bytes) + " of RAM" + given_up;
}

std::string text_of(const planner::SurfacePlan& plan)
{
    char text[120];
    std::snprintf(text, sizeof text, "%u triangles, %.1f texels a radius, at most %s", plan.draft->triangles(),
                  static_cast<double>(plan.settings.texels_per_radius), byte_text(plan.most_bytes).c_str());
    return text;
}

}  // namespace lumi::tools
