// SPDX-License-Identifier: MIT
#include "terminal/json_progress.h"

#include <nlohmann/json.hpp>

#include "terminal/interrupt.h"

namespace lumi::tools
{

namespace
{

constexpr double kSecondsBetweenObjects = 1;

}  // namespace

std::string progress_json(const baker::Progress& progress, const char* state)
{
    constexpr const char* kStages[] = {"light", "mesh", "solving", "training"};
    nlohmann::json line = {{"state", state},
                           {"stage", kStages[static_cast<size_t>(progress.stage)]},
                           {"rays_done", progress.rays_done},
                           {"rays_total", progress.rays_total},
                           {"rays_saved", progress.rays_saved},
                           {"rays_per_second", progress.rays_per_second},
                           {"elapsed_seconds", progress.elapsed_seconds},
                           {"eta_seconds", nullptr}};
    if (progress.eta_seconds >= 0) line["eta_seconds"] = progress.eta_seconds;
    return line.dump();
}

void JsonProgress::print(const baker::Progress& progress)
{
    last_ = progress;
    const bool all = progress.rays_done >= progress.rays_total;
    if (all ? said_all_ : progress.elapsed_seconds < next_line_seconds_) return;
    std::fprintf(stream_, "%s\n", progress_json(progress, state_).c_str());
    std::fflush(stream_);
    said_all_ = all;
    next_line_seconds_ = progress.elapsed_seconds + kSecondsBetweenObjects;
}

baker::ProgressCallback watch(JsonProgress& printer)
{
    return [&printer](const baker::Progress& progress) {
        printer.print(progress);
        return !interrupt_flag().load(std::memory_order_relaxed);
    };
}

}  // namespace lumi::tools
