// SPDX-License-Identifier: MIT
#include "terminal/progress_printer.h"

#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

constexpr double kSecondsBetweenLines = 5, kSilentSeconds = 2;
constexpr size_t kMostCells = 30, kFewestCells = 5, kUsualColumns = 80;

size_t columns_of(std::FILE* stream)
{
    winsize size = {};
    return ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsualColumns;
}

// As wide as there is room beside the text, or nothing.
std::string bar_text(double share, size_t room)
{
    constexpr size_t kFrame = 3;  // brackets and a blank
    if (room < kFewestCells + kFrame) return "";
    const size_t cells = std::min(kMostCells, room - kFrame);
    const double filled = std::clamp(share, 0.0, 1.0) * static_cast<double>(cells);
    std::string bar(static_cast<size_t>(filled), '#');
    bar.resize(cells, '.');
    return "[" + bar + "] ";
}

double share_done(const baker::Progress& progress)
{
    if (progress.share >= 0) return progress.share;
    if (progress.rays_total == 0) return 1;
    return static_cast<double>(progress.rays_done) / static_cast<double>(progress.rays_total);
}

}  // namespace

const char* stage_name(baker::Stage stage)
{
    constexpr const char* kNames[] = {"light", "mesh", "solving", "training", "measuring"};
    return kNames[static_cast<size_t>(stage)];
}

std::string progress_text(const baker::Progress& progress)
{
    const bool is_whole = progress.share >= 0;
    const std::string stage = is_whole || progress.stage != baker::Stage::light ? stage_name(progress.stage) : "";
    const std::string share = std::to_string(static_cast<int>(std::floor(100 * share_done(progress)))) + " %";
    std::string text = is_whole ? share + "  " + stage : stage + (stage.empty() ? "" : " ") + share;
    if (progress.rays_per_second > 0) text += "  " + count_text(progress.rays_per_second) + " rays/s";
    if (progress.eta_seconds >= 0) text += "  " + duration_text(progress.eta_seconds) + " left";
    return text;
}

ProgressPrinter::~ProgressPrinter()
{
    if (line_is_open_) std::fputc('\n', stream_);
}

void ProgressPrinter::print(const baker::Progress& progress)
{
    if (is_terminal_) return redraw_bar(progress);
    if (progress.rays_done == 0 && next_line_seconds_ > 0)  // the next of several jobs: its clock starts again
        next_line_seconds_ = kSecondsBetweenLines;
    if (progress.elapsed_seconds < next_line_seconds_) return;
    std::fprintf(stream_, "%s%s\n", step_.c_str(), progress_text(progress).c_str());
    std::fflush(stream_);
    next_line_seconds_ = progress.elapsed_seconds + kSecondsBetweenLines;
}

void ProgressPrinter::clear()
{
    if (line_is_open_) std::fputs("\r\x1b[K", stream_);
    std::fflush(stream_);
    line_is_open_ = false;
}

void ProgressPrinter::redraw_bar(const baker::Progress& progress)
{
    const size_t room = columns_of(stream_) - 1;  // a full last column begins a new line on some terminals
    const std::string text = (step_ + progress_text(progress)).substr(0, room);
    const std::string bar = bar_text(share_done(progress), room - text.size());
    // The escape clears what a longer earlier text left at the end of the line.
    std::fprintf(stream_, "\r%s%s\x1b[K", bar.c_str(), text.c_str());
    std::fflush(stream_);
    line_is_open_ = true;
}

baker::ProgressCallback watch(ProgressPrinter& printer)
{
    return [&printer](const baker::Progress& progress) {
        printer.print(progress);
        return !interrupt_flag().load(std::memory_order_relaxed);
    };
}

Teller::Teller(std::mutex& mutex, double first_seconds, std::function<double()> tell)
    : mutex_(mutex), tell_(std::move(tell))
{
    try {
        thread_ = std::thread([this, first_seconds] { run(first_seconds); });
    } catch (const std::system_error&) {
    }
}

Teller::~Teller()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    ended_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void Teller::run(double seconds)
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return ends_; })) seconds = tell_();
}

Waiting::Waiting(std::string what) : what_(std::move(what))
{
    teller_.emplace(
        mutex_, kSilentSeconds, [this] { return tell(); });
}

Waiting::~Waiting()
{
    teller_.reset();
    if (has_told_ && stderr_is_terminal()) std::fputs("\r\x1b[K", stderr);
}

void Waiting::now(std::string what)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    what_ = std::move(what);
}

double Waiting::tell()
{
    using Seconds = std::chrono::duration<double>;
    const bool is_terminal = stderr_is_terminal();
    const std::string time = duration_text(Seconds(std::chrono::steady_clock::now() - begin_).count());
    const std::string line = what_.substr(0, columns_of(stderr) - time.size() - 3) + "  " + time;
    std::fprintf(stderr, is_terminal ? "\r%s\x1b[K" : "%s\n", line.c_str());
    std::fflush(stderr);
    has_told_ = true;
    return is_terminal ? 1 : kSecondsBetweenLines;
}

bool stderr_is_terminal()
{
    return isatty(STDERR_FILENO) == 1;
}

WholeTime::WholeTime(std::vector<double> expected) : expected_(std::move(expected)) {}

baker::Progress WholeTime::of(const baker::Progress& own, double now)
{
    const double done =
        own.rays_total == 0 ? 1 : static_cast<double>(own.rays_done) / static_cast<double>(own.rays_total);
    // By what was expected of the part, unless its own share says that it takes longer.
    constexpr double kLeastDone = 0.05;
    if (part_begin_ < 0) part_begin_ = now;
    const double here = now - part_begin_, likely = done > kLeastDone ? here / done : here;
    double left = own.eta_seconds >= 0 ? own.eta_seconds : std::max(expected_[part_], likely) * (1 - done);
    for (size_t later = part_ + 1; later < expected_.size(); ++later) left += expected_[later];
    tells_eta_ = tells_eta_ || own.eta_seconds >= 0;
    if (now > 0) share_ = std::max(share_, std::min(1.0, now / (now + left)));
    baker::Progress whole = own;
    whole.share = share_;
    whole.eta_seconds = tells_eta_ ? left : -1;
    whole.elapsed_seconds = now;
    return whole;
}

namespace
{

constexpr double kSecondsBetweenObjects = 1;

}  // namespace

std::string progress_json(const baker::Progress& progress, const char* state)
{
    nlohmann::json line = {{"state", state},
                           {"stage", stage_name(progress.stage)},
                           {"rays_done", progress.rays_done},
                           {"rays_total", progress.rays_total},
                           {"rays_saved", progress.rays_saved},
                           {"rays_per_second", progress.rays_per_second},
                           {"elapsed_seconds", progress.elapsed_seconds},
                           {"eta_seconds", nullptr}};
    if (progress.eta_seconds >= 0) line["eta_seconds"] = progress.eta_seconds;
    if (progress.share >= 0) line["share"] = progress.share;
    return line.dump();
}

void JsonProgress::print(const baker::Progress& progress)
{
    const bool all = progress.rays_done >= progress.rays_total;
    if (all ? said_all_ : progress.elapsed_seconds < next_line_seconds_) return;
    std::fprintf(stream_, "%s\n", progress_json(progress, state_).c_str());
    std::fflush(stream_);
    said_all_ = all;
    next_line_seconds_ = progress.elapsed_seconds + kSecondsBetweenObjects;
}

}  // namespace lumi::tools
