// SPDX-License-Identifier: MIT
// How far a long computation is, and when it will end, judged by its recent pace.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <stdexcept>

namespace lumi::baker
{

// The work that a long computation does at the moment.
enum class Stage : uint8_t {
    light,     // rays are traced
    mesh,      // a surface field's mesh is made; rays stand for work that takes as long
    solving,   // a surface field's texels are solved for; rays stand for such work, too
    training,  // a filter is trained; rays stand for views seen
    measuring  // a field is compared with traced pictures
};

struct Progress {
    // Camera rays, i.e. whole light paths; also those of the checkpoint that a bake goes on from, and those that
    // adaptive sampling saved.
    uint64_t rays_done = 0;
    uint64_t rays_total = 0;
    double rays_per_second = 0;  // over the trailing window; 0 while unknown
    double eta_seconds = -1;     // negative while unknown
    double elapsed_seconds = 0;
    uint64_t rays_saved = 0;  // rays among those done by this call that were not traced, as their texels were settled
    Stage stage = Stage::light;
    double share = -1;  // of a longer work that has parts before and after; negative: rays tell it
};

// Called from the thread that started the work: once before the first ray, about ten times a second, once at the end.
// Returning false cancels: the work throws Cancelled and leaves nothing behind, a bake only its checkpoint.
using ProgressCallback = std::function<bool(const Progress&)>;

// Reports to `progress` what is work of one stage, all of it.
ProgressCallback as_stage(Stage stage, ProgressCallback progress);

struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

// Pace over a trailing window. Keeps no clock: the caller says what time it is, in seconds, never going backwards.
class RateMeter
{
public:
    explicit RateMeter(double window_seconds = 10.0) : window_seconds_(window_seconds) {}

    void add(double now_seconds, uint64_t done);
    // Units per second between the oldest and the newest report of the window; 0 before there are two.
    double per_second() const;
    // Seconds until `total` is reached at that pace, or at half the mean pace since the first report where that is
    // more: work that is counted in steps stands still between them. Negative while nothing is done.
    double eta_seconds(uint64_t total) const;

private:
    struct Report {
        double seconds;
        uint64_t done;
    };
    static double pace(const Report& from, const Report& to);

    double window_seconds_;
    Report first_ = {};
    std::deque<Report> reports_;
};

// Jobs that run one after the other, reported as one whose progress never goes back.
class JobSeries
{
public:
    // rays_total: of all jobs together. 0: nobody knows how many jobs there will be. Then each takes half of what is
    // left of a whole, and no ETA is told.
    explicit JobSeries(ProgressCallback progress, uint64_t rays_total = 0);

    // The next job reports to this; it keeps a reference. rays: its share of rays_total.
    ProgressCallback next(uint64_t rays = 0);
    // Counts a job that need not run.
    void skip(uint64_t rays);

private:
    bool report(const Progress& job);

    using Clock = std::chrono::steady_clock;
    ProgressCallback progress_;
    bool is_total_known_;
    uint64_t rays_total_;
    uint64_t rays_of_job_ = 0, rays_before_ = 0;
    Clock::time_point start_ = Clock::now();
    RateMeter meter_;
};

}  // namespace lumi::baker
