// SPDX-License-Identifier: MIT
#include "planner/chord_speed.h"

#include <numeric>
#include <stdexcept>

#include "lumi/orbit.h"
#include "planner/instruction_costs.h"

namespace lumi::planner
{

namespace
{

using tools::Mode;

const double (&costs_of(const std::string& core, Mode mode, const Field& field, int32_t span_px))[kChordItems]
{
    const size_t of_core = cost_index(core);
    const size_t of_mode = static_cast<size_t>(mode);
    if (!is_drawn_by_spans(field, mode, span_px)) return kExactCosts[of_core][of_mode];
    return kSpanCosts[of_core][of_mode][static_cast<size_t>(field.texel_format)];
}

Camera camera_of_generic_view(const host::ScreenSize& screen)
{
    const Orbit orbit = {degrees(37), degrees(23), radii(3)};
    Camera camera;
    if (make_camera(pose_of(orbit), image_of(orbit, screen.width_px, screen.height_px), camera) != CameraError::none)
        throw std::logic_error("the rated view has no camera");
    return camera;
}

}  // namespace

double chord_instructions(const std::string& core, Mode mode, const Field& field, int32_t span_px,
                          const ChordWork& work)
{
    const auto& costs = costs_of(core, mode, field, span_px);
    return std::inner_product(work.count.begin(), work.count.end(), std::begin(costs), 0.0);
}

std::vector<PartRate> chord_rates(const Field& field, Mode mode, int32_t span_px, const host::ScreenSize& screen)
{
    const ChordFrame frame = frame_of(field, mode, span_px, camera_of_generic_view(screen), screen);
    const AllTraffic traffic = traffic_of(frame.reads);
    std::vector<PartRate> rates;
    for (size_t k = 0; k < kChips; ++k) {
        const Chip& chip = kChipList[k];
        const double instructions = chord_instructions(chip.core, mode, field, span_px, frame.work);
        const double rate = frames_per_second(chip, static_cast<uint64_t>(instructions), traffic[k].misses,
                                              frame.work[ChordItem::image_px]);
        rates.push_back({&chip, rate, rate, instructions});
    }
    return rates;
}

}  // namespace lumi::planner
