// SPDX-License-Identifier: MIT
// What holds a frame rate, for any renderer whose pictures come in steps from coarse to fine. quality.h and
// surface/quality.h name the steps.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

struct LadderLimits {
    uint32_t budget;           // what a frame may take, in any unit; below 2^29
    const uint8_t* growth_q4;  // what a step costs at most, in sixteenths of the one before; of step 0 it is not read
    uint8_t coarsest, finest_moving;
    uint8_t coarsest_resting, finest_resting;
    uint8_t first;  // where it begins, or at the limit next to it
};

class QualityLadder
{
public:
    explicit QualityLadder(const LadderLimits& limits);

    // Chooses a step for what is drawn now; false if the finest one is on the display already. `last_frame` is what
    // drawing the last answer took (of the first call and where nothing was drawn, anything).
    bool next(uint32_t last_frame, bool moving);
    uint8_t step() const { return resting_ ? refined_ : moving_; }

private:
    bool has_room_above(uint32_t last_frame) const;
    void adapt(uint32_t last_frame);
    void refine();

    LadderLimits limits_;
    uint8_t moving_, refined_;
    bool resting_ = false, measured_ = false, finished_ = false;
    uint32_t roomy_frames_ = 0;      // frames in a row with room for a finer step
    uint32_t patience_;              // how many of them it takes
    uint32_t since_raised_ = kLong;  // frames since the last raise

    static constexpr uint32_t kLong = 1u << 20;
};

}  // namespace lumi::detail
