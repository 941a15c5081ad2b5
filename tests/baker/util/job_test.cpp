// SPDX-License-Identifier: MIT
#include "util/job.h"

#include <catch2/catch.hpp>
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
        for (const std::atomic<int>& r : runs) {
            REQUIRE(r == 1);
        }
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
                                  if (k == 3) {
                                      throw std::runtime_error("task three");
                                  }
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

}  // namespace lumi::baker
