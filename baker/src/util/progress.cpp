// SPDX-License-Identifier: MIT
#include "lumi/baker/progress.h"

#include <algorithm>
#include <utility>

namespace lumi::baker
{

ProgressCallback as_stage(Stage stage, ProgressCallback progress)
{
    if (!progress) return {};
    return [stage, progress = std::move(progress)](Progress own) {
        own.stage = stage;
        return progress(own);
    };
}

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

JobSeries::JobSeries(ProgressCallback progress, uint64_t rays_total)
    : progress_(std::move(progress)), is_total_known_(rays_total != 0), rays_total_(rays_total)
{
    constexpr uint64_t kWhole = 1'000'000;
    if (!is_total_known_) rays_total_ = kWhole;
}

ProgressCallback JobSeries::next(uint64_t rays)
{
    skip(rays_of_job_);
    rays_of_job_ = is_total_known_ ? rays : (rays_total_ - rays_before_) / 2;
    if (!progress_) return {};
    return [this](const Progress& job) { return report(job); };
}

void JobSeries::skip(uint64_t rays)
{
    rays_before_ += rays;
    rays_of_job_ = 0;
}

bool JobSeries::report(const Progress& job)
{
    const double share =
        job.rays_total != 0 ? static_cast<double>(job.rays_done) / static_cast<double>(job.rays_total) : 1;
    Progress all = job;
    all.elapsed_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    all.rays_done = rays_before_ + static_cast<uint64_t>(share * static_cast<double>(rays_of_job_));
    all.rays_total = rays_total_;
    meter_.add(all.elapsed_seconds, all.rays_done);
    all.rays_per_second = is_total_known_ ? meter_.per_second() : 0;
    all.eta_seconds = is_total_known_ ? meter_.eta_seconds(rays_total_) : -1;
    return progress_(all);
}

}  // namespace lumi::baker
