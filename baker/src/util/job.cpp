// SPDX-License-Identifier: MIT
#include "util/job.h"

#include <cmath>
#include <system_error>
#include <thread>
#include <vector>

#include "lumi/baker/bake.h"

namespace lumi::baker
{
namespace
{

constexpr std::chrono::milliseconds kReportInterval(100);
constexpr double kUsualPace = 3e5;  // rays a second
constexpr double kFirstEta = 0.02;  // share of the work done before an ETA is told: estimated work tells no pace

unsigned thread_count(unsigned wanted)
{
    const unsigned machine = std::thread::hardware_concurrency();
    return wanted != 0 ? wanted : machine != 0 ? machine : 1;
}

// Joins on every way out.
class Threads
{
public:
    ~Threads()
    {
        for (std::thread& t : threads_) t.join();
    }
    // False where the system gives no further thread: those that there are do the work.
    template <class Function>
    bool start(Function function)
    {
        try {
            threads_.emplace_back(std::move(function));
            return true;
        } catch (const std::system_error&) {
            return false;
        }
    }

private:
    std::vector<std::thread> threads_;
};

}  // namespace

Job::Job(uint64_t rays_total, unsigned threads, const ProgressCallback& progress, uint64_t rays_done)
    : rays_total_(rays_total), threads_(thread_count(threads)), progress_(progress), rays_done_(rays_done)
{
    report();
}

void Job::report()
{
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const uint64_t done = this->done();
    meter_.add(elapsed, done);
    const bool traces = stage_ == Stage::light;
    const bool tells_eta = traces || static_cast<double>(done) >= kFirstEta * static_cast<double>(rays_total_);
    if (progress_ && !progress_({done, rays_total_, traces ? meter_.per_second() : 0,
                                 tells_eta ? meter_.eta_seconds(rays_total_) : -1, elapsed, rays_saved_, stage_}))
        throw Cancelled();
}

uint64_t Job::part_of_rest(double share) const
{
    const uint64_t done = std::min<uint64_t>(rays_done_, rays_total_);
    return done + static_cast<uint64_t>(share * static_cast<double>(rays_total_ - done));
}

uint64_t Job::done() const
{
    if (run_.rays == 0) return rays_done_;
    double share = static_cast<double>(finished_tasks_) / run_.tasks;
    if (run_.tasks == 1) {
        const double seconds = std::chrono::duration<double>(Clock::now() - run_.start).count();
        share = 1 - std::exp(-seconds * kUsualPace / static_cast<double>(run_.rays));
    }
    return run_.from + static_cast<uint64_t>(share * static_cast<double>(run_.rays));
}

void Job::begin_run(uint32_t count)
{
    next_task_ = 0;
    finished_ = 0;
    finished_tasks_ = 0;
    if (!is_staged_ || count == 0 || stage_end_ <= rays_done_) return;
    const uint64_t left = stage_end_ - rays_done_;
    run_ = {rays_done_, left / std::max(runs_left_, 1u), count, Clock::now()};
    runs_left_ = runs_left_ > 2 ? runs_left_ - 1 : 2;  // there may be more runs than expected
}

void Job::end_run()
{
    rays_done_ += run_.rays;
    run_ = {};
}

void Job::work(uint32_t count, const std::function<void(uint32_t)>& task)
{
    try {
        for (uint32_t k = next_task_++; k < count && !stop_; k = next_task_++) {
            task(k);
            ++finished_tasks_;
        }
    } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        failure_ = std::current_exception();
        stop_ = true;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    ++finished_;
    finished_one_.notify_one();
}

void Job::watch(unsigned workers)
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (!finished_one_.wait_for(lock, kReportInterval, [&] { return finished_ == workers; })) {
        lock.unlock();
        report();
        lock.lock();
    }
}

void Job::run(uint32_t count, const std::function<void(uint32_t)>& task)
{
    begin_run(count);
    const unsigned workers = std::min(threads_, std::max(count, 1u));
    {
        Threads threads;
        try {
            unsigned started = 0;
            while (started < workers && threads.start([&] { work(count, task); })) ++started;
            if (started == 0) throw BakeError("the system gives no thread; raise `ulimit -v` and `ulimit -u`");
            watch(started);
        } catch (...) {
            stop_ = true;
            throw;
        }
    }
    if (failure_) std::rethrow_exception(failure_);
    end_run();
}

void Job::finish()
{
    report();
}

JobStage::JobStage(Job& job, Stage stage, uint64_t until, uint32_t runs) : job_(job)
{
    job.stage_ = stage;
    job.is_staged_ = true;
    job.stage_end_ = until;
    job.runs_left_ = std::max(runs, 1u);
}

JobStage::~JobStage()
{
    job_.rays_done_ = std::max<uint64_t>(job_.rays_done_, job_.stage_end_);
    job_.stage_ = Stage::light;
    job_.is_staged_ = false;
    job_.run_ = {};
}

}  // namespace lumi::baker
