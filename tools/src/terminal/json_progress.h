// SPDX-License-Identifier: MIT
// Shows a machine how far a bake is.
#pragma once

#include <cstdio>
#include <string>

#include "lumi/baker/progress.h"

namespace lumi::tools
{

// One line without its end: {"elapsed_seconds":3.0,"eta_seconds":9.5,"rays_done":437,"rays_per_second":124.0,
// "rays_saved":91,"rays_total":1000,"state":"baking"}; eta_seconds is null while unknown.
std::string progress_json(const baker::Progress& progress, const char* state = "baking");

// Prints such a line at the beginning, every second, and when all rays are done; each is flushed.
class JsonProgress
{
public:
    // state: a static text.
    explicit JsonProgress(std::FILE* stream, const char* state = "baking") : stream_(stream), state_(state) {}

    void print(const baker::Progress& progress);
    // The last report, for a closing line of the caller's.
    const baker::Progress& last() const { return last_; }

private:
    std::FILE* stream_;
    const char* state_;
    baker::Progress last_;
    double next_line_seconds_ = 0;
    bool said_all_ = false;
};

// A callback that prints through `printer` and cancels on Ctrl-C. Keeps a reference.
baker::ProgressCallback watch(JsonProgress& printer);

}  // namespace lumi::tools
