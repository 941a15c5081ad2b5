// SPDX-License-Identifier: MIT
#include "planner/surface_speed.h"

#include <algorithm>

#include "quality/held_out.h"

namespace lumi::planner
{

namespace
{

// Instructions a frame and a unit of load, fitted to counts of `lumi-lab bench`: the desk clock in 120 and 240 kB,
// finishes in 185 kB, plant and terrain of tools/lab/failure_scenes.sh in 490 kB, a model in 167 kB and a plain ball in
// 50 kB, each in the views `generic` and `pole`. Frame, vertices, patches, lit vertices and outlines are fitted to
// their parts of the counts, the others to what is left of the whole; none below 0.
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
constexpr Costs kM4[] = {{9390, 143, 256, 314, 589, 18.4, 24, 0, 0, 11.8},
                         {9400, 143, 340, 314, 618, 0, 47.9, 61.8, 326, 12.3},
                         {9380, 143, 248, 317, 582, 0, 27, 57.3, 0, 51.4}};
constexpr Costs kM0plus[] = {{64500, 227, 375, 692, 935, 13.1, 34.5, 0, 0, 18.6},
                             {64000, 227, 478, 690, 861, 0, 67.3, 119, 486, 21.6},
                             {61900, 227, 357, 697, 815, 0, 37.3, 101, 0, 81.5}};

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
