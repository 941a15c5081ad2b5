// SPDX-License-Identifier: MIT
#include "trade/chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "quality/html.h"
#include "trade/text.h"

namespace lumi::trade
{

namespace
{

constexpr double kWidth = 640, kHeight = 380;
constexpr double kLeft = 44, kRight = 20, kTop = 26, kBottom = 48;

std::string place(double value)
{
    return number(value, 1);
}

std::string tick_text(double rate)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", rate);
    return text;
}

std::string text_at(double x, double y, const char* style, const std::string& words)
{
    return "<text x=\"" + place(x) + "\" y=\"" + place(y) + "\" class=\"" + style + "\">" + quality::escaped(words) +
           "</text>";
}

std::string line(double x, double y, double x2, double y2, const char* style)
{
    return "<line x1=\"" + place(x) + "\" y1=\"" + place(y) + "\" x2=\"" + place(x2) + "\" y2=\"" + place(y2) +
           "\" class=\"" + style + "\"/>";
}

// From frames a second and dB to places: rates by their logarithm, since exact pixels are a hundred times slower.
class Axes
{
public:
    Axes(const Trade& trade, size_t part)
    {
        for (const Row& row : trade.rows) {
            if (row.parts.empty()) continue;
            least_rate_ = std::min(least_rate_, row.parts[part].frames_per_second);
            least_db_ = std::min(least_db_, row.measured->mean.psnr_db);
            most_db_ = std::max(most_db_, row.measured->mean.psnr_db);
        }
        least_rate_ *= kMargin;
        step_db_ = most_db_ - least_db_ > kManyDb ? 5 : most_db_ - least_db_ > kSomeDb ? 2 : 1;
        least_db_ = std::floor(least_db_ / step_db_ - kRoom) * step_db_;
        most_db_ = std::ceil(most_db_ / step_db_ + kRoom) * step_db_;
    }

    double x(double rate) const
    {
        return kLeft + (kWidth - kLeft - kRight) * std::log(rate / least_rate_) / std::log(kMostRate / least_rate_);
    }
    double y(double db) const
    {
        return kHeight - kBottom - (kHeight - kTop - kBottom) * (db - least_db_) / (most_db_ - least_db_);
    }

    std::string drawn() const
    {
        std::string svg;
        for (double db = least_db_; db <= most_db_; db += step_db_) {
            svg += line(kLeft, y(db), kWidth - kRight, y(db), "grid");
            svg += text_at(kLeft - 6, y(db) + 4, "end", std::to_string(std::lround(db)));
        }
        for (const double rate : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0}) {
            if (rate < least_rate_) continue;
            svg += line(x(rate), kTop, x(rate), kHeight - kBottom, "grid");
            svg += text_at(x(rate), kHeight - kBottom + 17, "mid", tick_text(rate));
        }
        return svg + text_at(kLeft, kTop - 12, "", "dB against path-traced truth") +
               text_at(kWidth - kRight, kHeight - 8, "end", "frames a second, modelled →");
    }

private:
    static constexpr double kMostRate = 80;  // the display takes 68
    static constexpr double kMargin = 0.85, kRoom = 0.3, kManyDb = 16, kSomeDb = 7;
    double least_rate_ = 8, least_db_ = 99, most_db_ = 0, step_db_ = 1;
};

class Chart
{
public:
    Chart(const Trade& trade, size_t part) : trade_(trade), part_(trade.parts[part]), index_(part), axes_(trade, part)
    {
        for (const Row& row : trade.rows) most_bytes_ = std::max(most_bytes_, row.measured->flash_bytes);
    }

    std::string drawn() const
    {
        std::string svg = axes_.drawn() + pace() + stairs();
        for (size_t k = 0; k < trade_.rows.size(); ++k)
            if (place_on_front(k) == 0 && !trade_.rows[k].parts.empty()) svg += mark(k, "beaten");
        for (const size_t k : largest_first()) svg += mark(k, trade_.rows[k].is_surface ? "surface" : "chord");
        for (const size_t k : part_.front) svg += label(k);
        return svg;
    }

private:
    // From 1 on; 0: it is not there.
    size_t place_on_front(size_t row) const
    {
        const auto found = std::find(part_.front.begin(), part_.front.end(), row);
        return found == part_.front.end() ? 0 : static_cast<size_t>(found - part_.front.begin()) + 1;
    }

    std::vector<size_t> largest_first() const
    {
        std::vector<size_t> order = part_.front;
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return radius(a) > radius(b); });
        return order;
    }

    double x(size_t k) const { return axes_.x(trade_.rows[k].parts[index_].frames_per_second); }
    double y(size_t k) const { return axes_.y(trade_.rows[k].measured->mean.psnr_db); }
    double radius(size_t k) const
    {
        constexpr double kLeast = 3, kMost = 15;
        const auto bytes = static_cast<double>(trade_.rows[k].measured->flash_bytes);
        return std::max(kLeast, kMost * std::sqrt(bytes / static_cast<double>(std::max<uint64_t>(1, most_bytes_))));
    }

    std::string mark(size_t k, const std::string& style) const
    {
        const bool is_recommended = !part_.front.empty() && k == part_.recommended;
        return "<circle cx=\"" + place(x(k)) + "\" cy=\"" + place(y(k)) + "\" r=\"" + place(radius(k)) + "\" class=\"" +
               style + (is_recommended ? " best" : "") + "\"><title>" +
               quality::escaped(name_of(trade_.rows[k]) + ": " + figures_text(trade_.rows[k], index_)) +
               "</title></circle>";
    }

    std::string label(size_t k) const
    {
        return text_at(x(k), y(k) - radius(k) - 5, "mid name", std::to_string(place_on_front(k)));
    }

    // The best accuracy at a rate or faster.
    std::string stairs() const
    {
        if (part_.front.empty()) return "";
        std::string path = "M" + place(x(part_.front[0])) + " " + place(y(part_.front[0]));
        for (const size_t k : part_.front) path += "H" + place(x(k)) + "V" + place(y(k));
        return "<path class=\"stairs\" d=\"" + path + "\"/>";
    }

    std::string pace() const
    {
        const double at = axes_.x(std::min(part_.pace.frames_per_second, 67.8));
        return line(at, kTop, at, kHeight - kBottom, "pace");
    }

    const Trade& trade_;
    const PartTrade& part_;
    const size_t index_;
    const Axes axes_;
    uint64_t most_bytes_ = 0;
};

}  // namespace

std::string chart_of(const Trade& trade, size_t part)
{
    return "<svg viewBox=\"0 0 640 380\" role=\"img\" aria-label=\"Frames a second and accuracy on " +
           quality::escaped(trade.parts[part].pace.chip->title) + "\">" + Chart(trade, part).drawn() + "</svg>\n";
}

}  // namespace lumi::trade
