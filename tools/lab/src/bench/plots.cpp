// SPDX-License-Identifier: MIT
#include "bench/plots.h"

#include "bench/svg.h"
#include "files/output_file.h"

namespace lumi::bench
{
namespace
{

PlotSeries series_of(const Results& results, const std::string& core, const std::string& mode, const std::string& texel)
{
    PlotSeries series = {mode + " " + texel, {}};
    for (const int span : kSpans) {
        const Result* result = find_result(results, core, mode, texel, span, "generic");
        if (result == nullptr) continue;
        series.points.push_back(
            {result->instructions_per_pixel(), result->accuracy.psnr_db, span == 0 ? "exact" : std::to_string(span)});
    }
    return series;
}

Plot plot_of(const Results& results, const std::string& core)
{
    Plot plot = {"Cost and accuracy on " + core + ", generic view; labels are span lengths in pixels",
                 "instructions per covered pixel",
                 "PSNR against exact, dB",
                 {}};
    for (const std::string& mode : kModes) {
        for (const std::string& texel : kTexels) {
            PlotSeries series = series_of(results, core, mode, texel);
            if (!series.points.empty()) plot.series.push_back(std::move(series));
        }
    }
    return plot;
}

}  // namespace

std::string plot_name(const std::string& core)
{
    return "tradeoff-" + core + ".svg";
}

std::vector<std::string> write_plots(const Results& results, const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    std::vector<std::string> names;
    for (const std::string& core : kCores) {
        const Plot plot = plot_of(results, core);
        if (plot.series.empty()) continue;
        names.push_back(plot_name(core));
        tools::write_output((folder / names.back()).string(), svg_of(plot));
    }
    return names;
}

}  // namespace lumi::bench
