// SPDX-License-Identifier: MIT
// Holds a frame rate of surface fields: one sample a pixel while an object moves too fast for more, 2 × 2 at rest.
//
//     SurfaceQuality control({33333});                    // microseconds a frame
//     const SurfaceFrameQuality q = control.next(last_us, is_moving);
//     if (q.draws) draw(q.mode);
//
// A pure function of its inputs: equal calls give equal answers, on every core.
#pragma once
#pragma GCC system_header

#include "lumi/detail/quality_ladder.h"
#include "lumi/surface/frame.h"

namespace lumi
{

struct SurfaceFrameQuality {
    bool draws;  // false: the finest picture is on the display already
    SurfaceMode mode;
};

// No mode may be finer than that of the view (SurfaceDrawing's kFinest, antialiased by default): View::look refuses it.
struct SurfaceQualityLimits {
    uint32_t budget;  // what a frame may take, in any unit: that of next()'s `last_frame`. Below 2^29.
    SurfaceMode coarsest = SurfaceMode::one_sample;
    SurfaceMode finest_moving = SurfaceMode::two_by_two;
    SurfaceMode finest_resting = SurfaceMode::two_by_two;
};

}  // namespace lumi

namespace lumi::detail
{

inline LadderLimits ladder_limits(const SurfaceQualityLimits& limits)
{
    static constexpr uint8_t kGrowth_q4[] = {16, 27, 33};  // measured: docs/log/tradeoff.md, with a margin
    const auto number = [](SurfaceMode mode) { return static_cast<uint8_t>(mode); };
    return {limits.budget,
            kGrowth_q4,
            number(limits.coarsest),
            number(limits.finest_moving),
            number(limits.coarsest),
            number(limits.finest_resting),
            number(SurfaceMode::antialiased)};
}

}  // namespace lumi::detail

namespace lumi
{

class SurfaceQuality
{
public:
    // Begins antialiased, or at the limit next to it.
    explicit SurfaceQuality(const SurfaceQualityLimits& limits) : ladder_(detail::ladder_limits(limits)) {}

    // As QualityControl::next.
    SurfaceFrameQuality next(uint32_t last_frame, bool moving)
    {
        const bool draws = ladder_.next(last_frame, moving);
        return {draws, static_cast<SurfaceMode>(ladder_.step())};
    }

private:
    detail::QualityLadder ladder_;
};

}  // namespace lumi
