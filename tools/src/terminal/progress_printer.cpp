// SPDX-License-Identifier: MIT
#include "terminal/progress_printer.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "terminal/interrupt.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

constexpr double kSecondsBetweenLines = 5;
constexpr int kBarCells = 30;

double share_done(const baker::Progress& progress)
{
    if (progress.rays_total == 0) return 1;
    return static_cast<double>(progress.rays_done) / static_cast<double>(progress.rays_total);
}

}  // namespace

std::string progress_text(const baker::Progress& progress)
{
    constexpr const char* kStages[] = {"", "mesh ", "solving ", "training "};
    std::string text = kStages[static_cast<size_t>(progress.stage)];
    text += std::to_string(static_cast<int>(std::floor(100 * share_done(progress)))) + " %";
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
    std::fprintf(stream_, "%s\n", progress_text(progress).c_str());
    std::fflush(stream_);
    next_line_seconds_ = progress.elapsed_seconds + kSecondsBetweenLines;
}

void ProgressPrinter::redraw_bar(const baker::Progress& progress)
{
    const int filled = std::clamp(static_cast<int>(kBarCells * share_done(progress)), 0, kBarCells);
    std::string bar(static_cast<size_t>(filled), '#');
    bar.resize(kBarCells, '.');
    // The escape clears what a longer earlier text left at the end of the line.
    std::fprintf(stream_, "\r[%s] %s\x1b[K", bar.c_str(), progress_text(progress).c_str());
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

baker::ProgressCallback watch_interrupt()
{
    return [](const baker::Progress&) { return !interrupt_flag().load(std::memory_order_relaxed); };
}

bool stderr_is_terminal()
{
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace lumi::tools
