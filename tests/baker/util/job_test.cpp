// SPDX-License-Identifier: MIT
#include "util/job.h"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

namespace lumi::baker
{

TEST_CASE("job: every task runs once, whatever the number of threads")
{
    for (const unsigned threads : {1u, 2u, 5u}) {
        const ProgressCallback none;
        Job job(1000, threads, none);
        std::vector<std::atomic<int>> runs(1000);
        job.run(1000, [&](uint32_t k) { ++runs[k]; });
        for (const std::atomic<int>& r : runs) REQUIRE(r == 1);
        job.run(0, [&](uint32_t) { FAIL("no task was asked for"); });
    }
}

TEST_CASE("job: reports the start and the end")
{
    std::vector<Progress> reports;
    const ProgressCallback note = [&](const Progress& p) {
        reports.push_back(p);
        return true;
    };
    Job job(10, 2, note);
    job.run(10, [&](uint32_t) { job.add_rays(1); });
    job.finish();
    REQUIRE(reports.size() >= 2);
    CHECK(reports.front().rays_done == 0);
    CHECK(reports.front().rays_total == 10);
    CHECK(reports.front().eta_seconds < 0);
    CHECK(reports.back().rays_done == 10);
}

TEST_CASE("job: what a task throws arrives at the caller and stops the others")
{
    const ProgressCallback none;
    Job job(1, 2, none);
    std::atomic<int> runs{0};
    CHECK_THROWS_WITH(job.run(1000000,
                              [&](uint32_t k) {
                                  ++runs;
                                  if (k == 3) throw std::runtime_error("task three");
                              }),
                      "task three");
    CHECK(runs < 1000000);
}

TEST_CASE("job: a callback that returns false while tasks run cancels them")
{
    int calls = 0;
    const ProgressCallback stop_at_second = [&](const Progress&) { return ++calls < 2; };
    Job job(1, 1, stop_at_second);
    CHECK_THROWS_AS(job.run(1,
                            [&](uint32_t) {
                                while (!job.stopping()) {
                                }
                            }),
                    Cancelled);
}

TEST_CASE("job: a stage moves on with its runs and ends where it was told, and never goes back")
{
    std::vector<Progress> reports;
    const ProgressCallback note = [&](const Progress& p) {
        reports.push_back(p);
        return true;
    };
    Job job(1000, 1, note, 100);
    {
        const JobStage stage(job, Stage::mesh, job.part_of_rest(0.5), 2);
        for (int runs = 0; runs < 5; ++runs) {  // more than were expected
            job.run(4, [](uint32_t) {});
            job.finish();
            CHECK(reports.back().stage == Stage::mesh);
            CHECK(reports.back().rays_done > 100);
            CHECK(reports.back().rays_done < 550);
        }
    }
    job.finish();
    CHECK(reports.back().rays_done == 550);
    CHECK(reports.back().stage == Stage::light);
    CHECK(std::is_sorted(reports.begin(), reports.end(),
                         [](const Progress& a, const Progress& b) { return a.rays_done < b.rays_done; }));
}

TEST_CASE("job: by a plan the time left counts rays by their pace, and other work by its own")
{
    constexpr double kUsualPace = 3e5, kRaysLeft = 3e6, kSeconds = 1.6;
    Progress last;
    const ProgressCallback note = [&](const Progress& p) {
        last = p;
        return true;
    };
    Job job(1, 1, note);
    job.plan(2 * static_cast<uint64_t>(kRaysLeft), 3000000);
    job.finish();
    CHECK(last.eta_seconds < 0);  // no ray has shown a pace
    job.run(1, [&](uint32_t) {
        std::this_thread::sleep_for(std::chrono::duration<double>(kSeconds));
        job.add_rays(static_cast<uint64_t>(kRaysLeft));
    });
    job.finish();
    CHECK(last.eta_seconds > kSeconds + 3e6 / kUsualPace - 0.1);
    CHECK(last.eta_seconds < 1.3 * kSeconds + 3e6 / kUsualPace);
    {
        const JobStage stage(job, Stage::solving, job.part_of_rest(0) + 3000000, 1);
    }
    job.finish();
    CHECK(last.eta_seconds == Approx(last.elapsed_seconds).epsilon(0.1));  // half of the rays
    job.plan(0, 0);
    job.finish();
    CHECK(last.eta_seconds == 0);
}

TEST_CASE("job: a run of one long task in a stage moves on while it runs")
{
    std::atomic<uint64_t> seen{0};
    const ProgressCallback note = [&](const Progress& p) {
        seen = p.rays_done;
        return true;
    };
    Job job(1000000, 1, note);
    const JobStage stage(job, Stage::solving, 1000000, 1);
    job.run(1, [&](uint32_t) {
        while (seen == 0)  // until a report says more
            std::this_thread::yield();
    });
    job.finish();
    CHECK(seen == 1000000);
}

}  // namespace lumi::baker
