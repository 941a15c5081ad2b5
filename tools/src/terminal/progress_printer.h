// SPDX-License-Identifier: MIT
// Shows a person or a machine how far a bake is.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "lumi/baker/progress.h"

namespace lumi::tools
{

// "light", "mesh" and so on.
const char* stage_name(baker::Stage stage);

// "43 %  1.24 M rays/s  1:12 left", "mesh 43 %  0:05 left"; of a longer work "43 %  mesh  0:05 left". Without what is
// not known yet.
std::string progress_text(const baker::Progress& progress);

// A bar that redraws itself on a terminal, else a plain line at the beginning and every few seconds. Lines are no wider
// than the terminal.
class ProgressPrinter
{
public:
    // step: what of a longer job this is, such as "2 of 3 baking: "; may be empty.
    ProgressPrinter(std::FILE* stream, bool is_terminal, std::string step = "")
        : stream_(stream), is_terminal_(is_terminal), step_(std::move(step))
    {
    }
    // Ends the bar's line, so that later messages begin on their own.
    ~ProgressPrinter();
    ProgressPrinter(const ProgressPrinter&) = delete;
    ProgressPrinter& operator=(const ProgressPrinter&) = delete;

    void print(const baker::Progress& progress);
    // Takes the bar's line away.
    void clear();

private:
    void redraw_bar(const baker::Progress& progress);

    std::FILE* stream_;
    bool is_terminal_;
    std::string step_;
    bool line_is_open_ = false;
    double next_line_seconds_ = 0;
};

// A callback that prints to stderr through `printer` and cancels on Ctrl-C. Keeps a reference.
baker::ProgressCallback watch(ProgressPrinter& printer);

// One share and one time left of works that follow each other and tell only their own: the share is that of the time.
// It never goes back.
class WholeTime
{
public:
    // Seconds that each takes, about.
    explicit WholeTime(std::vector<double> expected);

    void begin(size_t part)
    {
        part_ = part;
        part_begin_ = -1;
    }
    void expect(size_t part, double seconds) { expected_[part] = seconds; }
    // now: seconds since the first began.
    baker::Progress of(const baker::Progress& own, double now);

private:
    std::vector<double> expected_;
    size_t part_ = 0;
    double share_ = 0, part_begin_ = -1;  // seconds; negative: not yet
    bool tells_eta_ = false;              // as soon as one part knows its time, others are estimated
};

// Calls `tell` again and again from a thread of its own, with the mutex locked, until this is gone. `tell` returns the
// seconds until it is called next. Where the system has no thread left, it is not called.
class Teller
{
public:
    Teller(std::mutex& mutex, double first_seconds, std::function<double()> tell);
    ~Teller();
    Teller(const Teller&) = delete;
    Teller& operator=(const Teller&) = delete;

private:
    void run(double seconds);

    std::mutex& mutex_;
    const std::function<double()> tell_;
    std::condition_variable ended_;
    bool ends_ = false;
    std::thread thread_;
};

// Tells on stderr what a command does that is not done after two seconds, and for how long: on a terminal each second,
// in a line that vanishes with this, else every few seconds in a line of its own.
class Waiting
{
public:
    explicit Waiting(std::string what);
    ~Waiting();
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

    void now(std::string what);

private:
    double tell();

    const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::string what_;
    bool has_told_ = false;
    std::optional<Teller> teller_;
};

bool stderr_is_terminal();

// One line without its end: {"elapsed_seconds":3.0,"eta_seconds":9.5,"rays_done":437,"rays_per_second":124.0,
// "rays_saved":91,"rays_total":1000,"state":"baking"}; eta_seconds is null while unknown.
std::string progress_json(const baker::Progress& progress, const char* state = "baking");

// Prints such a line at the beginning, every second, and when all rays are done; each is flushed.
class JsonProgress
{
public:
    // `state` is a static text.
    explicit JsonProgress(std::FILE* stream, const char* state = "baking") : stream_(stream), state_(state) {}

    void print(const baker::Progress& progress);

private:
    std::FILE* stream_;
    const char* state_;
    double next_line_seconds_ = 0;
    bool said_all_ = false;
};

}  // namespace lumi::tools
