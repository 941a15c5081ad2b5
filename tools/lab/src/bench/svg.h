// SPDX-License-Identifier: MIT
// A scatter plot with lines, as SVG text: nothing but axes, series and a legend.
#pragma once

#include <string>
#include <vector>

namespace lumi::bench
{

struct PlotPoint {
    double x, y;
    std::string label;  // beside the point; may be empty
};

struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;  // joined in this order
};

struct Plot {
    std::string title, x_title, y_title;  // x is logarithmic
    std::vector<PlotSeries> series;
    bool narrow = false;  // drawn so that a phone's width shows it readably: half as wide, the legend below
};

// Series without points and points without finite values are left out. The same text for the same plot.
std::string svg_of(const Plot& plot);

}  // namespace lumi::bench
