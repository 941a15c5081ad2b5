// SPDX-License-Identifier: MIT
#include "svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lumi::bench
{
namespace
{

constexpr double kWidth = 880, kHeight = 520;
constexpr double kLeft = 60, kRight = 210, kTop = 40, kBottom = 50;
constexpr double kLegendRow = 17;
constexpr double kYStep = 5;  // decibels between grid lines
constexpr std::array<const char*, 10> kColours = {"#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee",
                                                  "#aa3377", "#777777", "#994f00", "#004488", "#bb5566"};
constexpr std::array<const char*, 4> kDashes = {"", "6 3", "2 3", "8 3 2 3"};

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof(text), "%.1f", value);
    return text;
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& words)
{
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + words +
           "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style)
{
    return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" + number(y2) +
           "\" " + style + "/>\n";
}

bool is_drawable(const PlotPoint& point)
{
    return std::isfinite(point.x) && std::isfinite(point.y) && point.x > 0;
}

// Maps values to the drawing, a little more than the extremes.
class Axes
{
public:
    explicit Axes(const Plot& plot)
    {
        for (const PlotSeries& series : plot.series) {
            for (const PlotPoint& point : series.points) {
                if (!is_drawable(point)) continue;
                low_x_ = std::min(low_x_, std::log10(point.x));
                high_x_ = std::max(high_x_, std::log10(point.x));
                low_y_ = std::min(low_y_, point.y);
                high_y_ = std::max(high_y_, point.y);
            }
        }
        constexpr double kMargin = 0.05;
        low_x_ -= kMargin;
        high_x_ += kMargin;
        low_y_ = kYStep * std::floor((low_y_ - 1) / kYStep);
        high_y_ = kYStep * std::ceil((high_y_ + 1) / kYStep);
    }

    bool is_empty() const { return low_x_ > high_x_; }
    double x(double value) const
    {
        return kLeft + (std::log10(value) - low_x_) / (high_x_ - low_x_) * (kWidth - kLeft - kRight);
    }
    double y(double value) const
    {
        return kHeight - kBottom - (value - low_y_) / (high_y_ - low_y_) * (kHeight - kTop - kBottom);
    }

    std::string grid() const
    {
        std::string svg;
        for (double value = low_y_; value <= high_y_; value += kYStep) {
            svg += line(kLeft, y(value), kWidth - kRight, y(value), "stroke=\"#dddddd\"");
            svg += text_at(kLeft - 6, y(value) + 4, "end", number(value));
        }
        for (int decade = static_cast<int>(std::floor(low_x_)); decade <= high_x_; ++decade)
            for (const int digit : {1, 2, 5}) svg += x_mark(digit * std::pow(10, decade));
        return svg;
    }

private:
    std::string x_mark(double value) const
    {
        if (std::log10(value) < low_x_ || std::log10(value) > high_x_) return "";
        char label[32];
        std::snprintf(label, sizeof(label), "%.0f", value);
        return line(x(value), kTop, x(value), kHeight - kBottom, "stroke=\"#dddddd\"") +
               text_at(x(value), kHeight - kBottom + 16, "middle", label);
    }

    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double low_x_ = kInfinity, high_x_ = -kInfinity, low_y_ = kInfinity, high_y_ = -kInfinity;
};

std::string draw_series(const PlotSeries& series, const Axes& axes, const std::string& colour, const std::string& dash)
{
    std::string path, marks;
    for (const PlotPoint& point : series.points) {
        if (!is_drawable(point)) continue;
        const double x = axes.x(point.x), y = axes.y(point.y);
        path += number(x) + "," + number(y) + " ";
        marks += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"3.5\" fill=\"" + colour + "\"/>\n";
        if (!point.label.empty()) marks += text_at(x + 5, y - 5, "start", point.label);
    }
    return "<polyline points=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-dasharray=\"" + dash +
           "\"/>\n" + marks;
}

std::string legend_entry(const std::string& name, double row, const std::string& colour, const std::string& dash)
{
    const double x = kWidth - kRight + 14, y = kTop + row * kLegendRow;
    return line(x, y, x + 26, y, "stroke=\"" + colour + "\" stroke-width=\"2\" stroke-dasharray=\"" + dash + "\"") +
           text_at(x + 32, y + 4, "start", name);
}

std::string draw_all_series(const Plot& plot, const Axes& axes)
{
    std::string svg;
    for (size_t i = 0; i < plot.series.size(); ++i) {
        const std::string colour = kColours[i % kColours.size()];
        const std::string dash = kDashes[i / kColours.size() % kDashes.size()];
        svg += draw_series(plot.series[i], axes, colour, dash);
        svg += legend_entry(plot.series[i].name, static_cast<double>(i), colour, dash);
    }
    return svg;
}

}  // namespace

std::string svg_of(const Plot& plot)
{
    const Axes axes(plot);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(kWidth) + " " +
                      number(kHeight) + "\" font-family=\"sans-serif\" font-size=\"11\">\n" +
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    if (!axes.is_empty()) svg += axes.grid() + draw_all_series(plot, axes);
    const double middle = (kLeft + kWidth - kRight) / 2;
    svg += text_at(middle, kTop - 16, "middle", plot.title);
    svg += text_at(middle, kHeight - 12, "middle", plot.x_title);
    svg += text_at(8, kTop - 16, "start", plot.y_title);
    return svg + "</svg>\n";
}

}  // namespace lumi::bench
