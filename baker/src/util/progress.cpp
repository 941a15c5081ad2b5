// SPDX-License-Identifier: MIT
#include "lumi/baker/progress.h"

namespace lumi::baker
{

void RateMeter::add(double now_seconds, uint64_t done)
{
    reports_.push_back({now_seconds, done});
    // Keep one report from before the window, so that the pace spans all of it.
    while (reports_.size() > 2 && reports_[1].seconds <= now_seconds - window_seconds_) {
        reports_.pop_front();
    }
}

double RateMeter::per_second() const
{
    if (reports_.size() < 2) {
        return 0;
    }
    const double seconds = reports_.back().seconds - reports_.front().seconds;
    const double done = static_cast<double>(reports_.back().done - reports_.front().done);
    return seconds > 0 ? done / seconds : 0;
}

double RateMeter::eta_seconds(uint64_t total) const
{
    const double pace = per_second();
    if (!(pace > 0)) {
        return -1;
    }
    return static_cast<double>(total - reports_.back().done) / pace;
}

}  // namespace lumi::baker
