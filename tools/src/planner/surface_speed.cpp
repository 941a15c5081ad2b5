// SPDX-License-Identifier: MIT
#include "planner/surface_speed.h"

#include <algorithm>

#include "quality/held_out.h"

namespace lumi::planner
{

namespace
{

// Instructions a frame and a unit of load, fitted to counts of the clock, the bunny and the dragon in two views.
struct Costs {
    double frame, vertex, patch, lit, seen, row, sample, outline, image;

    double of(const SurfaceLoad& load) const
    {
        return frame + vertex * load.vertices + patch * load.patches + lit * load.lit + seen * load.seen +
               row * load.rows + sample * load.samples + outline * load.outline + image * load.image;
    }
};

// By SurfaceMode.
constexpr Costs kM4[] = {{9300, 142, 215, 302, 682, 76.9, 31.8, 0, 11.5},
                         {9300, 142, 599, 302, 694, 73.9, 45.3, 449, 12.0},
                         {9300, 142, 215, 304, 741, 50.6, 31.5, 0, 22.5}};
constexpr Costs kM0plus[] = {{65400, 227, 299, 660, 1110, 112, 51.8, 0, 12.4},
                             {66100, 227, 910, 660, 1095, 118, 83.6, 691, 13.5},
                             {65400, 227, 300, 664, 1138, 76.3, 51.4, 0, 24.9}};

}  // namespace

double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceLoad& load)
{
    return (core == "m0plus" ? kM0plus : kM4)[static_cast<size_t>(mode)].of(load);
}

// Vertices and tables are read once, a patch once to be listed and once or twice to be filled; of texels, neighbours in
// a row of the image share half of the lines.
double surface_misses(const SurfaceLoad& load, double line_bytes)
{
    constexpr double kPatchReads = 2.5, kTexelLines = 0.5;
    const double mesh = format::kVertexBytes * load.vertices + format::kViewBytes * load.lit +
                        kPatchReads * format::kPatchBytes * load.patches;
    return mesh / line_bytes + kTexelLines * std::min(load.samples, load.image);
}

std::vector<PartRate> surface_rates(const SurfaceField& field, SurfaceMode mode)
{
    std::vector<SurfaceLoad> loads;
    for (const quality::HeldOutView& view : quality::held_out_views(quality::ViewSet::all, kRatedPoses))
        loads.push_back(load_of(field, view.eye, mode));
    std::vector<PartRate> rates;
    for (const bench::Chip& chip : bench::kChipList) {
        PartRate rate = {&chip, 0, 1e9};
        for (const SurfaceLoad& load : loads) {
            const auto instructions = static_cast<uint64_t>(surface_instructions(chip.core, mode, load));
            const auto misses = static_cast<uint64_t>(surface_misses(load, 1.0 * chip.cache.line_bytes));
            const double fps = bench::frames_per_second(chip, instructions, misses);
            rate.mean += fps / static_cast<double>(loads.size());
            rate.worst = std::min(rate.worst, fps);
        }
        rates.push_back(rate);
    }
    return rates;
}

}  // namespace lumi::planner
