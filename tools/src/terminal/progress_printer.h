// SPDX-License-Identifier: MIT
// Shows a person how far a bake is.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include "lumi/baker/progress.h"

namespace lumi::tools
{

// "43 %  1.24 M rays/s  1:12 left", "mesh 43 %  0:05 left"; without what is not known yet.
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
// Only asks for Ctrl-C.
baker::ProgressCallback watch_interrupt();

// Whether stderr is a terminal.
bool stderr_is_terminal();

}  // namespace lumi::tools
