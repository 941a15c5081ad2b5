// SPDX-License-Identifier: MIT
#include "util/job.h"

#include <thread>
#include <vector>

namespace lumi::baker
{
namespace
{

constexpr std::chrono::milliseconds kReportInterval(100);

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
        for (std::thread& t : threads_) {
            t.join();
        }
    }
    template <class Function>
    void start(Function function)
    {
        threads_.emplace_back(std::move(function));
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
    const uint64_t done = rays_done_;
    meter_.add(elapsed, done);
    if (progress_ &&
        !progress_({done, rays_total_, meter_.per_second(), meter_.eta_seconds(rays_total_), elapsed, rays_saved_})) {
        throw Cancelled();
    }
}

void Job::work(uint32_t count, const std::function<void(uint32_t)>& task)
{
    try {
        for (uint32_t k = next_task_++; k < count && !stop_; k = next_task_++) {
            task(k);
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
    next_task_ = 0;
    finished_ = 0;
    const unsigned workers = std::min(threads_, std::max(count, 1u));
    {
        Threads threads;
        try {
            for (unsigned t = 0; t < workers; ++t) {
                threads.start([&] { work(count, task); });
            }
            watch(workers);
        } catch (...) {
            stop_ = true;
            throw;
        }
    }
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

void Job::finish()
{
    report();
}

}  // namespace lumi::baker
