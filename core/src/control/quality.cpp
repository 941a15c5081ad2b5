// SPDX-License-Identifier: MIT
#include "lumi/quality.h"

namespace lumi::detail
{
namespace
{

constexpr uint32_t kMinPatience = 4;    // frames
constexpr uint32_t kMaxPatience = 128;  // a raise that fails again and again is tried every few seconds
constexpr uint32_t kTrial = 8;          // frames after a raise within which being late counts as its failure

uint8_t clamped(uint8_t step, uint8_t low, uint8_t high)
{
    return step < low ? low : step > high ? high : step;
}

}  // namespace

QualityLadder::QualityLadder(const LadderLimits& limits)
    : limits_(limits),
      moving_(clamped(limits.first, limits.coarsest, limits.finest_moving)),
      refined_(moving_),
      patience_(kMinPatience)
{
}

bool QualityLadder::next(uint32_t last_frame, bool moving)
{
    if (moving) {
        // A frame at rest says nothing about those that must be in time.
        if (measured_ && !resting_) adapt(last_frame);
        resting_ = false;
    } else {
        refine();
    }
    measured_ = true;
    return !(resting_ && finished_);
}

bool QualityLadder::has_room_above(uint32_t last_frame) const
{
    return moving_ < limits_.finest_moving && last_frame <= limits_.budget / limits_.growth_q4[moving_ + 1] * 16;
}

void QualityLadder::adapt(uint32_t last_frame)
{
    if (since_raised_ < kLong) ++since_raised_;
    const bool late = last_frame > limits_.budget;
    roomy_frames_ = has_room_above(last_frame) ? roomy_frames_ + 1 : 0;
    if (late && moving_ > limits_.coarsest) {
        // A raise that failed makes the next one wait longer, so that quality does not swing.
        if (since_raised_ <= kTrial && patience_ < kMaxPatience) patience_ *= 2;
        const bool very_late = last_frame > 2 * limits_.budget;
        --moving_;
        if (very_late && moving_ > limits_.coarsest) --moving_;
        since_raised_ = kLong;
    } else if (roomy_frames_ >= patience_) {
        ++moving_;
        roomy_frames_ = 0;
        since_raised_ = 0;
    }
}

// The first frame at rest repeats the step of the last moving one without its shortcuts; each further one is a step
// finer.
void QualityLadder::refine()
{
    if (!resting_) {
        resting_ = true;
        finished_ = false;
        refined_ = clamped(moving_, limits_.coarsest_resting, limits_.finest_resting);
        patience_ = kMinPatience;
        roomy_frames_ = 0;
    } else if (refined_ < limits_.finest_resting) {
        ++refined_;
    } else {
        finished_ = true;
    }
}

}  // namespace lumi::detail
