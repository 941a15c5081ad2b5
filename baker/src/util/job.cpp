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
constexpr double kUsualPace = 3e5;     // rays a second
constexpr double kFirstSeconds = 1.5;  // of tracing, before an ETA is told
constexpr double kPriorSeconds = 8;    // for which stages are taken to have had the usual pace
constexpr double kFirstEta = 0.02;     // share of the work done before an ETA is told: estimated work tells no pace

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
    : rays_total_(rays_total),
      threads_(thread_count(threads)),
      progress_(progress),
      rays_done_(rays_done),
      first_done_(rays_done)
{
    finish();
}

bool Job::report()
{
    const double now = elapsed();
    const uint64_t done = this->done();
    meter_.add(now, done);
    const bool traces = stage_ == Stage::light;
    return !progress_ ||
           progress_({done, rays_total_, traces ? meter_.per_second() : 0, eta_seconds(now), now, rays_saved_, stage_});
}

double Job::elapsed() const
{
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

double Job::eta_seconds(double now) const
{
    const auto done = static_cast<double>(this->done()), total = static_cast<double>(rays_total_);
    if (!has_plan_) return stage_ == Stage::light || done >= kFirstEta * total ? meter_.eta_seconds(rays_total_) : -1;
    const double in_stage = is_staged_ ? done - static_cast<double>(stage_begin_) : 0;
    const double staged = static_cast<double>(staged_done_) + in_stage;
    const double staged_seconds = staged_seconds_ + (is_staged_ ? now - stage_start_ : 0);
    const double traced = done - static_cast<double>(first_done_) - staged, traced_seconds = now - staged_seconds;
    const double staged_left = std::max(0.0, static_cast<double>(staged_left_) - in_stage);
    const double rays_left = std::max(0.0, total - done - staged_left);
    const bool is_known = traced > 0 && traced_seconds >= kFirstSeconds;
    if (rays_left > 0 && !is_known) return -1;
    const double pace = (kPriorSeconds * kUsualPace + staged) / (kPriorSeconds + staged_seconds);
    return staged_left / pace + (rays_left > 0 ? rays_left * traced_seconds / traced : 0);
}

void Job::plan(uint64_t rays_left, uint64_t staged_left)
{
    rays_total_ = rays_done_ + rays_left + staged_left;
    staged_left_ = staged_left;
    has_plan_ = true;
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
        finish();
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
    if (!report()) throw Cancelled();
}

void Job::tell()
{
    report();
}

JobStage::JobStage(Job& job, Stage stage, uint64_t until, uint32_t runs) : job_(job)
{
    job.stage_ = stage;
    job.is_staged_ = true;
    job.stage_end_ = until;
    job.runs_left_ = std::max(runs, 1u);
    job.stage_begin_ = job.rays_done_;
    job.stage_start_ = job.elapsed();
}

JobStage::~JobStage()
{
    job_.rays_done_ = std::max<uint64_t>(job_.rays_done_, job_.stage_end_);
    const uint64_t done = job_.rays_done_ - job_.stage_begin_;
    job_.staged_done_ += done;
    job_.staged_left_ -= std::min(done, job_.staged_left_);
    job_.staged_seconds_ += job_.elapsed() - job_.stage_start_;
    job_.stage_ = Stage::light;
    job_.is_staged_ = false;
    job_.run_ = {};
}

}  // namespace lumi::baker
