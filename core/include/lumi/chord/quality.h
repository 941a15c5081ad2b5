// SPDX-License-Identifier: MIT
// Holds a frame rate of chord fields (surface/quality.h: of surface fields): what to draw next, from how long the last
// frame took.
//
//     QualityControl control({33333});                    // microseconds a frame
//     const FrameQuality q = control.next(last_us, is_moving);
//     if (q.draws) draw(q.interlaced ? interlaced_half(camera, q.parity) : camera, q.one_tap, q.span_px);
//
// While the object moves, quality goes down a step as soon as a frame takes longer than its budget, and up again where
// there is room. Once it rests, every call refines it until the finest step has been drawn; then there is nothing to
// draw. A pure function of its inputs: equal calls give equal answers, on every core.
#pragma once
#pragma GCC system_header

#include "lumi/chord/camera.h"
#include "lumi/detail/quality_ladder.h"

namespace lumi
{

// How to draw a frame.
struct FrameQuality {
    bool draws;       // false: the finest picture is on the display already
    bool one_tap;     // Nearest in place of the product's reconstruction
    bool interlaced;  // the scanlines of `parity` alone, see interlaced_half()
    int32_t parity;   // 0 or 1, alternating from frame to frame
    int32_t span_px;  // for render_spans(); 1: for render(), the exact one
};

// The steps, coarse to fine; each costs more than the one before.
enum class QualityStep : uint8_t {
    one_tap_interlaced,  // one tap, spans of 16, every other scanline
    one_tap,             // one tap, spans of 16
    spans16,             // the product's reconstruction
    spans8,
    spans4,
    spans2,
    exact,
};

struct QualityLimits {
    uint32_t budget;  // what a frame may take, in any unit: that of next()'s `last_frame`. Below 2^29.
    QualityStep coarsest = QualityStep::one_tap_interlaced;
    QualityStep finest_moving = QualityStep::spans4;  // spans of 4 look like exact ones
    QualityStep finest_resting = QualityStep::exact;  // at least finest_moving and spans16
};

}  // namespace lumi

namespace lumi::detail
{

LadderLimits ladder_limits(const QualityLimits& limits);
int32_t span_px_of(QualityStep step);

}  // namespace lumi::detail

namespace lumi
{

class QualityControl
{
public:
    // Begins at spans of 16, or at the limit next to it.
    explicit QualityControl(const QualityLimits& limits);

    // What to draw now. `last_frame` is what drawing the last answer took (of the first call and where nothing was
    // drawn, anything); `moving`: whether the view differs from the last one. Costs some tens of instructions.
    FrameQuality next(uint32_t last_frame, bool moving);

    // The step of the last answer.
    QualityStep step() const { return static_cast<QualityStep>(ladder_.step()); }

private:
    detail::QualityLadder ladder_;
    int32_t parity_ = 1;
};

}  // namespace lumi
