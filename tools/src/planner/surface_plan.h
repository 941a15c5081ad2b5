// SPDX-License-Identifier: MIT
// From a size in bytes to a surface field: how many triangles, and how many texels the rest of the bytes hold. Nothing
// is traced: a mesh or two are drafted, which takes seconds to a minute, and a few more where RAM is scarce.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "lumi/baker/surface.h"
#include "lumi/host/view_memory.h"

namespace lumi::planner
{

inline constexpr uint32_t kMostPlannedTriangles = 6000;  // more are asked for by hand

// Of a view that draws up to `antialiased`, with its stripe.
struct RamLimit {
    uint64_t bytes;
    host::ScreenSize screen;
};

struct SurfaceTask {
    uint64_t budget_bytes = 500'000;
    std::optional<RamLimit> ram;
    baker::SurfaceSettings settings;  // what is set by hand, and what a plan leaves alone
    bool triangles_by_hand = false, edge_by_hand = false, density_by_hand = false;
    std::filesystem::path output;  // the field to bake: what is done of meshes is kept beside it; empty: nothing is
};

struct SurfacePlan {
    baker::SurfaceSettings settings;
    std::shared_ptr<const baker::SurfaceDraft> draft;
    uint64_t most_bytes = 0;
    uint64_t ram_bytes = 0;              // 0 where the task has no limit
    uint32_t triangles_without_ram = 0;  // of the mesh that the limit made coarser; 0: it did not
};

// Throws NoPlan (no_plan.h) where not even the coarsest mesh fits size and RAM, BakeError for a scene that no surface
// field can hold, Cancelled. A scene without a surface gets a plan whose draft has no triangles.
SurfacePlan plan_surface(const baker::Scene& scene, const SurfaceTask& task, const baker::ProgressCallback& progress);

// The options of `lumi bake` that set the same by hand.
std::string options_of(const SurfacePlan& plan);

}  // namespace lumi::planner
