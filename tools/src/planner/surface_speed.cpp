// SPDX-License-Identifier: MIT
#include "planner/surface_speed.h"

#include <algorithm>
#include <numeric>

#include "planner/instruction_costs.h"
#include "quality/held_out.h"

namespace lumi::planner
{

double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceWork& work)
{
    const auto& costs = kSurfaceCosts[cost_index(core)][static_cast<size_t>(mode)];
    return std::inner_product(work.count.begin(), work.count.end(), std::begin(costs), 0.0);
}

// Vertices and tables are read once, a patch once to be listed and once or twice to be filled; of texels, neighbours in
// a scanline share half of the lines.
double surface_misses(const SeeThroughField& field, const SurfaceWork& work, double line_bytes)
{
    constexpr double kPatchReads = 2.5, kSeeThroughReads = 3.5, kTexelLines = 0.5;
    const double mesh = detail::format::kVertexBytes * work[SurfaceItem::vertex] +
                        detail::format::view_bytes(field.code_bits) * work[SurfaceItem::lit] +
                        kPatchReads * detail::format::kPatchBytes * work[SurfaceItem::patch];
    const double see_through = kSeeThroughReads * detail::format::kPatchBytes * work[SurfaceItem::see_patch];
    const auto texels = [&](SurfaceItem plain, SurfaceItem magnified) {
        return kTexelLines * std::min(work[plain] + work[magnified], work[SurfaceItem::image_px]);
    };
    return (mesh + see_through) / line_bytes + texels(SurfaceItem::sample, SurfaceItem::magnified_sample) +
           texels(SurfaceItem::see_sample, SurfaceItem::see_magnified_sample);
}

int rated_poses(const host::ScreenSize& screen)
{
    constexpr double kMostPixels = 480.0 * 480 * kRatedPoses, kFewest = 4;
    return static_cast<int>(std::clamp<double>(kMostPixels / screen.width_px / screen.height_px, kFewest, kRatedPoses));
}

std::vector<PartRate> surface_rates(const SeeThroughField& field, SurfaceMode mode, const host::ScreenSize& screen)
{
    std::vector<SurfaceWork> works;
    for (quality::HeldOutView& view : quality::held_out_views(quality::ViewSet::all, rated_poses(screen))) {
        const double fov_deg = host::framing_fov_deg(screen.width_px, screen.height_px, view.distance);
        view.eye.image = host::make_image(screen.width_px, screen.height_px, fov_deg);
        works.push_back(work_of(field, view.eye, mode, screen.stripe_rows()));
    }
    std::vector<PartRate> rates;
    for (const Chip& chip : kChipList) {
        PartRate rate = {&chip, 0, 1e9, 0};
        for (const SurfaceWork& work : works) {
            const auto instructions = static_cast<uint64_t>(surface_instructions(chip.core, mode, work));
            const auto misses = static_cast<uint64_t>(surface_misses(field, work, 1.0 * chip.cache.line_bytes));
            const double fps = frames_per_second(chip, instructions, misses, work[SurfaceItem::image_px]);
            rate.mean += fps / static_cast<double>(works.size());
            rate.worst = std::min(rate.worst, fps);
            rate.instructions += static_cast<double>(instructions) / static_cast<double>(works.size());
        }
        rates.push_back(rate);
    }
    return rates;
}

}  // namespace lumi::planner
