// SPDX-License-Identifier: MIT
#include "planner/surface_speed.h"

#include <algorithm>

#include "quality/held_out.h"

namespace lumi::planner
{

namespace
{

// Instructions of a see-through triangle that faces the eye, and of its samples: fitted to what `lumi-lab bench`
// counted of a bottle, a pane and two cars in the views `generic` and `pole`, order and blends together.
struct SeeThroughCosts {
    double seen, sample, magnified;

    double of(const TriangleLoad& load) const
    {
        return seen * load.seen + sample * load.samples + magnified * load.magnified;
    }
};

// Instructions a frame and a unit of load, fitted to counts of `lumi-lab bench` in the views `generic` and `pole`:
// frame, vertices, patches, lit vertices and outlines to their parts of the counts, of the desk clock in four sizes,
// the test card in two, finishes, a plain ball and three models; set-ups, halvings and samples to the wholes that
// surface_speed.h names; none below 0.
struct Costs {
    double frame, vertex, patch, lit, set_up, halving, sample, magnified, outline, image;
    SeeThroughCosts see_through;

    double of(const SurfaceLoad& load) const
    {
        return frame + vertex * load.vertices + patch * load.patches + lit * load.lit + set_up * load.set_ups +
               halving * (load.halvings + load.see_through.halvings) + sample * load.samples +
               magnified * load.magnified + outline * load.outline + image * load.image +
               see_through.of(load.see_through);
    }
};

// By SurfaceMode.
constexpr Costs kM4[] = {{9120, 143, 208, 304, 706, 2820, 22.2, 0, 0, 3.53, {3120, 79.4, 0}},
                         {9120, 143, 242, 304, 652, 3800, 34.6, 28.2, 284, 4.91, {3550, 88.8, 109}},
                         {9120, 143, 208, 305, 609, 3160, 39.5, 37.3, 0, 12.7, {6900, 63.5, 121}}};
constexpr Costs kM0plus[] = {{15900, 231, 301, 585, 1060, 7730, 31.6, 0, 0, 4.95, {4810, 136, 0}},
                             {16700, 231, 366, 585, 982, 9560, 50.1, 58.5, 428, 7.81, {5260, 152, 134}},
                             {15900, 231, 302, 586, 925, 8390, 54.2, 74.9, 0, 17.6, {9410, 110, 156}}};

}  // namespace

double surface_instructions(const std::string& core, SurfaceMode mode, const SurfaceLoad& load)
{
    return (core == "m0plus" ? kM0plus : kM4)[static_cast<size_t>(mode)].of(load);
}

// Vertices and tables are read once, a patch once to be listed and once or twice to be filled; of texels, neighbours in
// a scanline share half of the lines.
double surface_misses(const SurfaceLoad& load, double line_bytes)
{
    constexpr double kPatchReads = 2.5, kSeeThroughReads = 3.5, kTexelLines = 0.5;
    const double mesh = detail::format::kVertexBytes * load.vertices + load.view_bytes * load.lit +
                        kPatchReads * detail::format::kPatchBytes * load.patches;
    const double see_through = kSeeThroughReads * detail::format::kPatchBytes * load.see_through_patches;
    return (mesh + see_through) / line_bytes +
           kTexelLines * (std::min(load.samples, load.image) + std::min(load.see_through.samples, load.image));
}

std::vector<PartRate> surface_rates(const SeeThroughField& field, SurfaceMode mode, const host::ScreenSize& screen)
{
    std::vector<SurfaceLoad> loads;
    for (quality::HeldOutView& view : quality::held_out_views(quality::ViewSet::all, kRatedPoses)) {
        const double fov_deg = host::framing_fov_deg(screen.width_px, screen.height_px, view.distance);
        view.eye.image = host::make_image(screen.width_px, screen.height_px, fov_deg);
        loads.push_back(load_of(field, view.eye, mode, screen.stripe_rows()));
    }
    std::vector<PartRate> rates;
    for (const Chip& chip : kChipList) {
        PartRate rate = {&chip, 0, 1e9, 0};
        for (const SurfaceLoad& load : loads) {
            const auto instructions = static_cast<uint64_t>(surface_instructions(chip.core, mode, load));
            const auto misses = static_cast<uint64_t>(surface_misses(load, 1.0 * chip.cache.line_bytes));
            const double fps = frames_per_second(chip, instructions, misses, load.image);
            rate.mean += fps / static_cast<double>(loads.size());
            rate.worst = std::min(rate.worst, fps);
            rate.instructions += static_cast<double>(instructions) / static_cast<double>(loads.size());
        }
        rates.push_back(rate);
    }
    return rates;
}

}  // namespace lumi::planner
