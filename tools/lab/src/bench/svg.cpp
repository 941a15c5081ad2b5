// SPDX-License-Identifier: MIT
#include "bench/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lumi::bench
{
namespace
{

// Where the grid lies, and the legend's first row.
struct Frame {
    double width, height;
    double left, right, top, bottom;  // borders around the grid
    double legend_x, legend_y;
};

constexpr double kLegendRow = 17;
constexpr Frame kWide = {880, 520, 60, 210, 40, 50, 684, 40};

Frame frame_of(const Plot& plot)
{
    if (!plot.narrow) return kWide;
    constexpr double kGridBottom = 300, kLegendTop = 350;
    const double height = kLegendTop + kLegendRow * static_cast<double>(plot.series.size());
    return {440, height, 48, 40, 28, height - kGridBottom, 48, kLegendTop};
}

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
    Axes(const Plot& plot, const Frame& frame) : frame_(frame)
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
        return frame_.left + (std::log10(value) - low_x_) / (high_x_ - low_x_) * (right() - frame_.left);
    }
    double y(double value) const { return bottom() - (value - low_y_) / (high_y_ - low_y_) * (bottom() - frame_.top); }

    std::string grid() const
    {
        std::string svg;
        for (double value = low_y_; value <= high_y_; value += kYStep) {
            svg += line(frame_.left, y(value), right(), y(value), "stroke=\"#dddddd\"");
            svg += text_at(frame_.left - 6, y(value) + 4, "end", number(value));
        }
        for (int decade = static_cast<int>(std::floor(low_x_)); decade <= high_x_; ++decade)
            for (int digit = 1; digit < 10; ++digit)
                if (is_marked(digit)) svg += x_mark(digit * std::pow(10, decade));
        return svg;
    }
    double right() const { return frame_.width - frame_.right; }
    double bottom() const { return frame_.height - frame_.bottom; }
    const Frame& frame() const { return frame_; }

private:
    // 1, 2 and 5 of each decade; all digits where hardly one of these would be in sight.
    bool is_marked(int digit) const
    {
        constexpr double kFewDecades = 0.5;
        return digit == 1 || digit == 2 || digit == 5 || high_x_ - low_x_ < kFewDecades;
    }

    std::string x_mark(double value) const
    {
        if (std::log10(value) < low_x_ || std::log10(value) > high_x_) return "";
        char label[32];
        std::snprintf(label, sizeof(label), "%.0f", value);
        return line(x(value), frame_.top, x(value), bottom(), "stroke=\"#dddddd\"") +
               text_at(x(value), bottom() + 16, "middle", label);
    }

    const Frame frame_;
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

std::string legend_entry(const std::string& name, double x, double y, const std::string& colour,
                         const std::string& dash)
{
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
        const Frame& frame = axes.frame();
        svg += legend_entry(plot.series[i].name, frame.legend_x, frame.legend_y + static_cast<double>(i) * kLegendRow,
                            colour, dash);
    }
    return svg;
}

}  // namespace

std::string svg_of(const Plot& plot)
{
    const Frame frame = frame_of(plot);
    const Axes axes(plot, frame);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(frame.width) + " " +
                      number(frame.height) + "\" font-family=\"sans-serif\" font-size=\"11\">\n" +
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    if (!axes.is_empty()) svg += axes.grid() + draw_all_series(plot, axes);
    const double middle = (frame.left + axes.right()) / 2;
    constexpr double kAboveGrid = 16, kBelowGrid = 38;
    svg += text_at(middle, frame.top - kAboveGrid, "middle", plot.title);
    svg += text_at(middle, axes.bottom() + kBelowGrid, "middle", plot.x_title);
    svg += text_at(8, frame.top - kAboveGrid, "start", plot.y_title);
    return svg + "</svg>\n";
}

}  // namespace lumi::bench
