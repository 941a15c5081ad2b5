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

std::string reason(const planner::SurfacePlan& plan, double limit)
{
    const baker::MeshLoss& loss = plan.draft->loss();
    if (loss.missed <= limit) return "";
    char text[160];
    std::snprintf(text, sizeof text,
                  "of the light paths that meet the scene %.1f %% miss a mesh of %u triangles (limit %.0f %%), %.1f %% "
                  "meet it elsewhere",
                  100 * loss.missed, plan.draft->triangles(), 100 * limit, 100 * loss.displaced);
    return text;
}

}  // namespace

SurfaceChoice surface_choice(const baker::Scene& scene, const planner::SurfaceTask& task,
                             const baker::ProgressCallback& progress)
{
    try {
        planner::SurfacePlan plan = planner::plan_surface(scene, task, progress);
        if (plan.draft->triangles() == 0) return {{}, "no light path meets a surface"};
        return {plan, reason(plan, scene.mesh_is_shell() ? kMostMissedOfVolume : kMostMissed)};
    } catch (const planner::NoPlan& none) {
        return {{}, none.what()};
    } catch (const baker::BakeError& error) {
        return {{}, error.what()};
    } catch (const baker::Cancelled&) {
        throw_interrupted(task.output.string());
    }
}

std::string text_of(const planner::SurfacePlan& plan)
{
    char text[120];
    std::snprintf(text, sizeof text, "%u triangles, %.1f texels a radius, at most %s", plan.draft->triangles(),
                  static_cast<double>(plan.settings.texels_per_radius), byte_text(plan.most_bytes).c_str());
    return text;
}

}  // namespace lumi::tools
