// SPDX-License-Identifier: MIT
#include "lumi/baker/progress.h"

#include <algorithm>

namespace lumi::baker
{

void RateMeter::add(double now_seconds, uint64_t done)
{
    reports_.push_back({now_seconds, done});
    if (reports_.size() == 1) first_ = reports_.front();
    // Keep one report from before the window, so that the pace spans all of it.
    while (reports_.size() > 2 && reports_[1].seconds <= now_seconds - window_seconds_) reports_.pop_front();
}

double RateMeter::pace(const Report& from, const Report& to)
{
    const double seconds = to.seconds - from.seconds;
    return seconds > 0 ? static_cast<double>(to.done - from.done) / seconds : 0;
}

double RateMeter::per_second() const
{
    return reports_.empty() ? 0 : pace(reports_.front(), reports_.back());
}

double RateMeter::eta_seconds(uint64_t total) const
{
    constexpr double kSlowest = 0.5;  // the pace is taken for at least this share of the mean pace
    const double likely = reports_.empty() ? 0 : std::max(per_second(), kSlowest * pace(first_, reports_.back()));
    return likely > 0 ? static_cast<double>(total - std::min(total, reports_.back().done)) / likely : -1;
}

}  // namespace lumi::baker
