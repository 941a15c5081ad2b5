// SPDX-License-Identifier: MIT
#include "lumi/quality.h"

namespace lumi
{
namespace
{

// What a step costs at most, in sixteenths of the one before: docs/log/tradeoff.md, with a margin. From one tap to the
// product's reconstruction it is that of 3×3; where it costs more, a raise fails and is tried ever more seldom.
constexpr uint8_t kGrowth_q4[] = {16, 34, 34, 20, 22, 28, 250};
constexpr uint32_t kMinPatience = 4;    // frames
constexpr uint32_t kMaxPatience = 128;  // a raise that fails again and again is tried every few seconds
constexpr uint32_t kTrial = 8;          // frames after a raise within which being late counts as its failure

QualityStep clamped(QualityStep step, QualityStep low, QualityStep high)
{
    return step < low ? low : step > high ? high : step;
}

QualityStep raised(QualityStep step)
{
    return static_cast<QualityStep>(static_cast<uint8_t>(step) + 1);
}

QualityStep lowered(QualityStep step)
{
    return static_cast<QualityStep>(static_cast<uint8_t>(step) - 1);
}

bool has_room_for(QualityStep step, const QualityLimits& limits, uint32_t last_frame)
{
    return step <= limits.finest_moving && last_frame <= limits.budget / kGrowth_q4[static_cast<uint8_t>(step)] * 16;
}

int32_t span_px_of(QualityStep step)
{
    switch (step) {
        case QualityStep::one_tap_interlaced:
        case QualityStep::one_tap:
        case QualityStep::spans16:
            return 16;
        case QualityStep::spans8:
            return 8;
        case QualityStep::spans4:
            return 4;
        case QualityStep::spans2:
            return 2;
        case QualityStep::exact:
            break;
    }
    return 1;
}

}  // namespace

QualityControl::QualityControl(const QualityLimits& limits)
    : limits_(limits),
      moving_(clamped(QualityStep::spans16, limits.coarsest, limits.finest_moving)),
      refined_(moving_),
      patience_(kMinPatience)
{
}

FrameQuality QualityControl::next(uint32_t last_frame, bool moving)
{
    if (moving) {
        // A frame at rest says nothing about those that must be in time.
        if (measured_ && !resting_) adapt(last_frame);
        resting_ = false;
    } else {
        refine();
    }
    measured_ = true;
    parity_ ^= 1;
    const QualityStep now = step();
    return {!(resting_ && finished_), now <= QualityStep::one_tap, now == QualityStep::one_tap_interlaced, parity_,
            span_px_of(now)};
}

void QualityControl::adapt(uint32_t last_frame)
{
    if (since_raised_ < kLong) ++since_raised_;
    const bool late = last_frame > limits_.budget;
    roomy_frames_ = has_room_for(raised(moving_), limits_, last_frame) ? roomy_frames_ + 1 : 0;
    if (late && moving_ > limits_.coarsest) {
        // A raise that failed makes the next one wait longer, so that quality does not swing.
        if (since_raised_ <= kTrial && patience_ < kMaxPatience) patience_ *= 2;
        const bool very_late = last_frame > 2 * limits_.budget;
        moving_ = lowered(moving_);
        if (very_late && moving_ > limits_.coarsest) moving_ = lowered(moving_);
        since_raised_ = kLong;
    } else if (roomy_frames_ >= patience_) {
        moving_ = raised(moving_);
        roomy_frames_ = 0;
        since_raised_ = 0;
    }
}

// The first frame at rest repeats the step of the last moving one without its shortcuts; each further one is a step
// finer.
void QualityControl::refine()
{
    if (!resting_) {
        resting_ = true;
        finished_ = false;
        refined_ = clamped(moving_, QualityStep::spans16, limits_.finest_resting);
        patience_ = kMinPatience;
        roomy_frames_ = 0;
        return;
    }
    if (refined_ < limits_.finest_resting) {
        refined_ = raised(refined_);
    } else {
        finished_ = true;
    }
}

}  // namespace lumi
