// SPDX-License-Identifier: MIT
#include "planner/surface_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lumi/baker/bake.h"
#include "lumi/surface/format.h"
#include "planner/no_plan.h"
#include "planner/ram.h"

namespace lumi::planner
{

namespace
{

using baker::SurfaceDraft;
using baker::SurfaceSettings;

// Triangles come first: the mesh takes about two fifths of the bytes.
constexpr double kBytesATriangle = 90;  // bytes of the budget; with split edges and view tables the mesh takes about 35
constexpr double kFewestTriangles = 100;
constexpr double kMostForMesh = 0.5;  // share of the budget
constexpr float kLongestEdge = 0.6f, kLongerEdge = 1.4f;

// Texels along a line of one radius, in steps that options can name.
constexpr int kStepsARadius = 10;
constexpr int kCoarsest = kStepsARadius, kFinest = 250 * kStepsARadius;  // a 480-pixel display shows no more

float density_of(int steps)
{
    return static_cast<float>(steps) / kStepsARadius;
}

bool fits(const SurfaceDraft& draft, int steps, uint64_t budget)
{
    try {
        return draft.most_bytes(density_of(steps)) <= budget;
    } catch (const baker::BakeError&) {
        return false;  // more texels than the format holds
    }
}

// Precondition: the coarsest fits.
int finest_that_fits(const SurfaceDraft& draft, uint64_t budget)
{
    int low = kCoarsest, high = kFinest + 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (fits(draft, middle, budget) ? low : high) = middle;
    }
    return low;
}

uint32_t triangles_for(double bytes)
{
    return static_cast<uint32_t>(std::clamp(bytes / kBytesATriangle, kFewestTriangles, double{kMostPlannedTriangles}));
}

// Splitting edges takes some kilobytes, however few triangles there are.
float edge_for(double bytes)
{
    constexpr double kShort = 0.2, kBytesForShort = 100'000;
    return static_cast<float>(std::clamp(kShort * std::sqrt(kBytesForShort / bytes), kShort, double{kLongestEdge}));
}

// Makes the mesh of `settings` smaller, which takes this share of the bytes: first by longer edges, since splitting
// them shows less than triangles do. False where it cannot be.
bool shrink(const SurfaceTask& task, double share, SurfaceSettings& s)
{
    if (!task.edge_by_hand && s.longest_edge < kLongestEdge) {
        s.longest_edge = std::min(kLongestEdge, kLongerEdge * s.longest_edge);
        return true;
    }
    if (task.triangles_by_hand || s.triangles <= kFewestTriangles) return false;
    s.triangles = std::max(static_cast<uint32_t>(kFewestTriangles),
                           static_cast<uint32_t>(s.triangles * std::min(0.8, 0.5 / share)));
    return true;
}

// As the view draws that `lumi embed` writes, unless a program says otherwise.
constexpr SurfaceMode kPlannedMode = SurfaceMode::antialiased;

uint64_t planned_ram(const SurfaceDraft& draft, const host::ScreenSize& screen)
{
    const host::SurfaceCounts counts = {draft.vertices(), draft.patches(), kPlannedMode, draft.see_through_patches()};
    return ram_of(counts, screen).all();
}

// RAM that does not depend on the mesh.
uint64_t least_ram(const host::ScreenSize& screen)
{
    return ram_of(host::SurfaceCounts{0, 0, kPlannedMode, 0}, screen).all();
}

// Makes the mesh of `settings` smaller, whose share of RAM is `needed` bytes and may be `room`: as shrink() does, but
// to the size. False where it cannot be.
bool shrink_to(double room, double needed, const SurfaceTask& task, SurfaceSettings& s)
{
    constexpr double kLeastStep = 0.95;  // so that there are few drafts
    const double share = std::min(kLeastStep, room / needed);
    if (!task.edge_by_hand && s.longest_edge < kLongestEdge) {
        s.longest_edge = std::min(kLongestEdge, s.longest_edge / static_cast<float>(std::sqrt(share)));
        return true;
    }
    if (task.triangles_by_hand || s.triangles <= kFewestTriangles) return false;
    s.triangles = std::max(static_cast<uint32_t>(kFewestTriangles), static_cast<uint32_t>(s.triangles * share));
    return true;
}

// Whether the plan's mesh keeps the limit of RAM; if not, its settings are made smaller. Throws NoPlan.
bool keeps_ram(const SurfaceTask& task, SurfacePlan& plan)
{
    if (!task.ram) return true;
    const host::ScreenSize& screen = task.ram->screen;
    plan.ram_bytes = planned_ram(*plan.draft, screen);
    if (plan.ram_bytes <= task.ram->bytes) return true;
    if (plan.triangles_without_ram == 0) plan.triangles_without_ram = plan.draft->triangles();
    const double least = static_cast<double>(least_ram(screen));
    const double room = static_cast<double>(task.ram->bytes) - least,
                 needed = static_cast<double>(plan.ram_bytes) - least;
    if (room > 0 && shrink_to(room, needed, task, plan.settings)) return false;
    throw NoPlan("view and stripe of " + std::to_string(screen.stripe_rows()) + " rows take " +
                 std::to_string(plan.ram_bytes) + " bytes of RAM with a mesh of " +
                 std::to_string(plan.draft->triangles()) + " triangles, " + std::to_string(least_ram(screen)) +
                 " without any; give more --ram, or fewer --rows");
}

}  // namespace

SurfacePlan plan_surface(const baker::Scene& scene, const SurfaceTask& task, const baker::ProgressCallback& progress)
{
    const double budget = static_cast<double>(task.budget_bytes);
    SurfacePlan plan;
    plan.settings = task.settings;
    if (!task.triangles_by_hand) plan.settings.triangles = triangles_for(budget);
    if (!task.edge_by_hand) plan.settings.longest_edge = edge_for(budget);
    baker::JobSeries trials(progress);
    for (;;) {
        plan.draft = std::make_shared<SurfaceDraft>(scene, plan.settings, trials.next(), task.output);
        if (plan.draft->triangles() == 0) return plan;
        const int coarsest = task.density_by_hand ? 0 : kCoarsest;
        const float density = task.density_by_hand ? task.settings.texels_per_radius : density_of(coarsest);
        const uint64_t least = plan.draft->most_bytes(density);
        const double most = task.density_by_hand || task.triangles_by_hand ? budget : kMostForMesh * budget;
        const bool is_small = static_cast<double>(least) <= most;
        if (!is_small && shrink(task, static_cast<double>(least) / budget, plan.settings)) continue;
        if (!is_small && least > task.budget_bytes)
            throw NoPlan("nothing fits into " + std::to_string(task.budget_bytes) +
                         " bytes; the smallest that works takes " + std::to_string(least) + " bytes");
        if (keeps_ram(task, plan)) break;
    }
    if (!task.density_by_hand)
        plan.settings.texels_per_radius = density_of(finest_that_fits(*plan.draft, task.budget_bytes));
    plan.most_bytes = plan.draft->most_bytes(plan.settings.texels_per_radius);
    return plan;
}

std::string options_of(const SurfacePlan& plan)
{
    char text[200];
    std::snprintf(text, sizeof text, "--layout surface --triangles %u --longest-edge %.6g --texel-density %.6g",
                  plan.settings.triangles, static_cast<double>(plan.settings.longest_edge),
                  static_cast<double>(plan.settings.texels_per_radius));
    std::string options = text;
    if (plan.settings.cap < 1) {
        std::snprintf(text, sizeof text, " --cap %.6g%%", 100 * static_cast<double>(plan.settings.cap));
        options += text;
    }
    if (!plan.settings.view_tables) options += " --no-view-tables";
    return options;
}

}  // namespace lumi::planner
