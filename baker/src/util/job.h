// SPDX-License-Identifier: MIT
// A long computation cut into independent tasks, run on several threads while the calling thread reports progress.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

#include "lumi/baker/progress.h"

namespace lumi::baker
{

class Job
{
public:
    // Reports once. threads = 0: as many as the machine has. rays_done: by an earlier job, whose work goes on. Throws
    // Cancelled.
    Job(uint64_t rays_total, unsigned threads, const ProgressCallback& progress, uint64_t rays_done = 0);

    // Runs task(k) for each k below count, in no fixed order, each once. Throws Cancelled, or what a task threw; either
    // way no task runs any more when it returns.
    void run(uint32_t count, const std::function<void(uint32_t)>& task);

    // Reports once more. Throws Cancelled.
    void finish();
    // Reports where nothing may be cancelled.
    void tell();

    // For tasks: counts rays, of which `saved` need not be traced, and tells whether to give up early.
    void add_rays(uint64_t rays, uint64_t saved = 0)
    {
        rays_done_ += rays;
        rays_saved_ += saved;
    }
    bool stopping() const { return stop_; }
    unsigned threads() const { return threads_; }

    // The work that is left, so much of it in stages. From then on an ETA is told by the pace of each kind, once rays
    // have shown theirs.
    void plan(uint64_t rays_left, uint64_t staged_left);

    // Where a part of the work that is left ends, in rays.
    uint64_t part_of_rest(double share) const;

private:
    friend class JobStage;
    using Clock = std::chrono::steady_clock;

    // A run that takes its place in a stage; reports are made from it.
    struct Run {
        uint64_t from = 0, rays = 0;
        uint32_t tasks = 0;
        Clock::time_point start{};
    };

    bool report();  // false: to be cancelled
    uint64_t done() const;
    double elapsed() const;
    double eta_seconds(double now) const;
    void begin_run(uint32_t count);
    void end_run();
    void work(uint32_t count, const std::function<void(uint32_t)>& task);
    void watch(unsigned workers);

    uint64_t rays_total_;
    const unsigned threads_;
    const ProgressCallback progress_;
    const Clock::time_point start_ = Clock::now();
    RateMeter meter_;

    std::atomic<uint64_t> rays_done_;
    std::atomic<uint64_t> rays_saved_{0};
    std::atomic<uint32_t> next_task_{0}, finished_tasks_{0};
    std::atomic<bool> stop_{false};
    std::mutex mutex_;  // guards what follows
    std::condition_variable finished_one_;
    unsigned finished_ = 0;
    std::exception_ptr failure_;

    // Only the calling thread uses these:
    Stage stage_ = Stage::light;
    bool is_staged_ = false;
    uint64_t stage_end_ = 0;
    uint32_t runs_left_ = 0;
    Run run_;
    bool has_plan_ = false;
    const uint64_t first_done_;
    uint64_t staged_left_ = 0, staged_done_ = 0;  // when the present stage began
    double staged_seconds_ = 0;                   // before it
    uint64_t stage_begin_ = 0;
    double stage_start_ = 0;  // seconds
};

// While it lives, what the job runs is one stage of it: tasks need not count rays, and the stage ends when `until` rays
// are done. There are about `runs` runs, and each takes an equal share. A run of one task cannot tell how far it is: it
// moves on with time.
class JobStage
{
public:
    JobStage(Job& job, Stage stage, uint64_t until, uint32_t runs);
    ~JobStage();
    JobStage(const JobStage&) = delete;
    JobStage& operator=(const JobStage&) = delete;

private:
    Job& job_;
};

}  // namespace lumi::baker
