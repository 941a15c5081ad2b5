// SPDX-License-Identifier: MIT
// How far the mean of a texel's light paths may still be off, in steps of the 8-bit scale that it will be stored in.
//
// The standard error of the mean of independent paths, carried through tone curve and encoding. Our paths are
// stratified, so it is an upper estimate. A texel that happened to miss a rare bright path looks quieter than it is,
// and a rule that stops at quiet moments would darken pictures: so one path more is assumed, kUnseen times as bright as
// the brightest so far. What is left of that bias is measured in docs/log/speed.md.
#pragma once

#include "image/tone.h"
#include "trace/path_tracer.h"

namespace lumi::baker
{

class ErrorGauge
{
public:
    static constexpr uint32_t kFirstLook = 16;  // paths before which no texel ends: coverage is not known better
    static constexpr uint32_t kBatch = 8;       // paths between two looks

    void add(const PathResult& path);

    uint32_t paths() const { return paths_; }
    // Whether the texel needs no further path: all paths agree on its coverage, and every channel's error is below
    // `max_levels`. Asks only where a batch ends.
    bool settled(ToneCurve tone, float max_levels) const;
    // The largest channel's standard error, of 255. Needs a covered path.
    float error_levels(ToneCurve tone) const;

private:
    struct Channel {
        double sum = 0, squares = 0, brightest = 0;
    };

    float standard_error(const Channel& channel) const;

    uint32_t paths_ = 0, hits_ = 0;
    Channel channels_[3];
};

}  // namespace lumi::baker
