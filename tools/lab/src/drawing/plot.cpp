// SPDX-License-Identifier: MIT
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/svg.h"
#include "commands.h"
#include "files/output_file.h"

namespace lumi::tools::bench
{

namespace
{

lumi::bench::PlotSeries series_of(const nlohmann::json& json)
{
    lumi::bench::PlotSeries series = {json.at("name"), {}};
    for (const auto& point : json.at("points"))
        series.points.push_back({point.at(0), point.at(1), point.size() > 2 ? point.at(2).get<std::string>() : ""});
    return series;
}

}  // namespace

void write_plot(const std::string& data, const std::string& svg)
{
    std::ifstream file(data);
    if (!file) throw std::runtime_error(data + ": cannot be read");
    const nlohmann::json json = nlohmann::json::parse(file);
    lumi::bench::Plot plot = {json.at("title"), json.at("x_title"), json.at("y_title"), {}};
    for (const auto& series : json.at("series")) plot.series.push_back(series_of(series));
    write_output(svg, lumi::bench::svg_of(plot));
}

}  // namespace lumi::tools::bench
