// SPDX-License-Identifier: MIT
#include "lumi/baker/progress.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

namespace lumi::baker
{

TEST_CASE("rate meter: knows nothing before two reports")
{
    RateMeter meter(10);
    CHECK(meter.per_second() == 0);
    CHECK(meter.eta_seconds(100) < 0);
    meter.add(5, 0);
    CHECK(meter.per_second() == 0);
    meter.add(5, 10);  // no time has passed
    CHECK(meter.per_second() == 0);
    CHECK(meter.eta_seconds(100) < 0);
}

TEST_CASE("rate meter: a steady pace gives its rate and the time left")
{
    RateMeter meter(10);
    for (int t = 0; t <= 50; ++t) meter.add(t, static_cast<uint64_t>(t) * 20);
    CHECK(meter.per_second() == Approx(20));
    CHECK(meter.eta_seconds(2000) == Approx(50));
    CHECK(meter.eta_seconds(1000) == Approx(0));
}

TEST_CASE("rate meter: forgets what lies before its window")
{
    RateMeter meter(10);
    uint64_t done = 0;
    for (int t = 0; t < 100; ++t) {
        meter.add(t, done);
        done += t < 50 ? 1000 : 10;
    }
    CHECK(meter.per_second() == Approx(10));
}

TEST_CASE("rate meter: a standstill has no end in sight")
{
    RateMeter meter(2);
    for (int t = 0; t < 10; ++t) meter.add(t, 5);
    CHECK(meter.eta_seconds(10) < 0);
}

TEST_CASE("rate meter: work that stands still for a while is expected to go on at half its mean pace")
{
    RateMeter meter(10);
    for (int t = 0; t <= 100; ++t) meter.add(t, 500 + 20 * static_cast<uint64_t>(std::min(t, 50)));
    CHECK(meter.per_second() == 0);
    CHECK(meter.eta_seconds(2000) == Approx(500 / (0.5 * 10)));
    CHECK(meter.eta_seconds(1000) == Approx(0));  // there was more to do than expected
}

namespace
{

// The reports of a series of jobs of so many rays each, every one of which reports at its beginning, half-way and at
// its end.
std::vector<Progress> reports_of(JobSeries& series, std::vector<Progress>& reports,
                                 std::initializer_list<uint64_t> jobs)
{
    for (const uint64_t rays : jobs) {
        const ProgressCallback report = series.next(rays);
        for (const uint64_t done : {uint64_t{0}, rays / 2, rays}) {
            Progress job;
            job.rays_total = rays;
            job.rays_done = done;
            CHECK(report(job));
        }
    }
    return reports;
}

std::vector<uint64_t> done_in(const std::vector<Progress>& reports)
{
    std::vector<uint64_t> done;
    for (const Progress& report : reports) done.push_back(report.rays_done);
    return done;
}

}  // namespace

TEST_CASE("job series: jobs of known size fill one bar, and those that need not run count as done")
{
    std::vector<Progress> reports;
    JobSeries series([&](const Progress& p) { return reports.push_back(p), true; }, 100);
    series.skip(20);
    CHECK(done_in(reports_of(series, reports, {20, 60})) == std::vector<uint64_t>{20, 30, 40, 40, 70, 100});
    for (const Progress& report : reports) CHECK(report.rays_total == 100);
}

TEST_CASE("job series: nobody knows how many jobs, and still progress never goes back, and no time is promised")
{
    std::vector<Progress> reports;
    JobSeries series([&](const Progress& p) { return reports.push_back(p), true; });
    const std::vector<uint64_t> done = done_in(reports_of(series, reports, {1000, 10, 500, 20}));
    CHECK(std::is_sorted(done.begin(), done.end()));
    CHECK(done.back() < reports.back().rays_total);
    for (const Progress& report : reports) CHECK(report.eta_seconds < 0);
}

TEST_CASE("job series: what the caller answers reaches the job")
{
    JobSeries series([](const Progress&) { return false; }, 10);
    CHECK_FALSE(series.next(10)(Progress()));
    CHECK_FALSE(JobSeries({}, 10).next(10));  // nobody listens
}

}  // namespace lumi::baker
