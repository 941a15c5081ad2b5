// SPDX-License-Identifier: MIT
#include "planner/surface_speed.h"

#include <algorithm>

#include "quality/held_out.h"

namespace lumi::planner
{

namespace
{

// Instructions a frame and a unit of load, fitted part by part to counts of `lumi-lab bench`: the clock in 120 and 245 kB,
// gallery in 200 kB and a glass ball in 434 kB, each in two views.
struct Costs {
    double frame, vertex, patch, lit, seen, scanline, sample, magnified, outline, image;

    double of(const SurfaceLoad& load) const
    {
        return frame + vertex * load.vertices + patch * load.patches + lit * load.lit + seen * load.seen +
               scanline * load.scanlines + sample * load.samples + magnified * load.magnified + outline * load.outline +
               image * load.image;
    }
};

// By SurfaceMode.
constexpr Costs kM4[] = {{9190, 147, 315, 324, 749, 77.7, 31.7, 0, 0, 8.4},
                         {9750, 147, 335, 324, 788, 72.1, 47.4, 25.7, 594, 9},
                         {9190, 147, 314, 325, 797, 53.7, 35.6, 43.4, 0, 16}};
constexpr Costs kM0plus[] = {{63100, 228, 512, 712, 1160, 113, 47.2, 0, 0, 9.4},
                             {63100, 228, 540, 712, 1220, 113, 71.6, 54.8, 994, 10.2},
                             {63200, 228, 511, 713, 1200, 79.2, 53, 85.8, 0, 18.3}};

}  // namespace

double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceLoad& load)
{
    return (core == "m0plus" ? kM0plus : kM4)[static_cast<size_t>(mode)].of(load);
}

// Vertices and tables are read once, a patch once to be listed and once or twice to be filled; of texels, neighbours in
// a scanline share half of the lines.
double surface_misses(const SurfaceLoad& load, double line_bytes)
{
    constexpr double kPatchReads = 2.5, kTexelLines = 0.5;
    const double mesh = detail::format::kVertexBytes * load.vertices + detail::format::kViewBytes * load.lit +
                        kPatchReads * detail::format::kPatchBytes * load.patches;
    return mesh / line_bytes + kTexelLines * std::min(load.samples, load.image);
}

std::vector<PartRate> surface_rates(const SurfaceField& field, SurfaceMode mode)
{
    std::vector<SurfaceLoad> loads;
    for (const quality::HeldOutView& view : quality::held_out_views(quality::ViewSet::all, kRatedPoses))
        loads.push_back(load_of(field, view.eye, mode));
    std::vector<PartRate> rates;
    for (const Chip& chip : kChipList) {
        PartRate rate = {&chip, 0, 1e9};
        for (const SurfaceLoad& load : loads) {
            const auto instructions = static_cast<uint64_t>(surface_instructions(chip.core, mode, load));
            const auto misses = static_cast<uint64_t>(surface_misses(load, 1.0 * chip.cache.line_bytes));
            const double fps = frames_per_second(chip, instructions, misses);
            rate.mean += fps / static_cast<double>(loads.size());
            rate.worst = std::min(rate.worst, fps);
        }
        rates.push_back(rate);
    }
    return rates;
}

}  // namespace lumi::planner
