// SPDX-License-Identifier: MIT
#include "trade/page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "quality/page.h"
#include "terminal/text.h"
#include "trade/text.h"

namespace lumi::trade
{

namespace
{

using quality::cell;
using quality::escaped;
using quality::number;

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
    return "<text x=\"" + place(x) + "\" y=\"" + place(y) + "\" class=\"" + style + "\">" + escaped(words) + "</text>";
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
               escaped(name_of(trade_.rows[k]) + ": " + figures_text(trade_.rows[k], index_)) + "</title></circle>";
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
           escaped(trade.parts[part].pace.chip->title) + "\">" + Chart(trade, part).drawn() + "</svg>\n";
}

namespace
{

// This is how the trade looks on the report page: chart and pictures side by side where there is room.
constexpr char kTradeStyle[] = R"(
:root { --surface: #2a6fc9; --chord: #c8641b; --beaten: #8889; }
@media (prefers-color-scheme: dark) { :root { --surface: #6ea8ff; --chord: #f0924a; } }
.part { border: 1px solid var(--line); border-radius: 10px; padding: 0.2rem 1rem 1rem; margin: 1rem 0; }
.part h2 { margin-top: 0.7rem; }
.answer { font-size: 1.1rem; max-width: none; }
.part pre { overflow-x: auto; background: var(--soft); border-radius: 6px; padding: 0.5rem 0.7rem; margin: 0.5rem 0;
  font-size: 0.85rem; }
.sides { display: grid; grid-template-columns: minmax(0, 11fr) minmax(0, 9fr); gap: 1rem; align-items: start; }
.thumbs { display: grid; grid-template-columns: repeat(auto-fill, minmax(108px, 1fr)); gap: 0.5rem; }
.thumbs .best { outline: 3px solid var(--surface); }
.sides svg { display: block; width: 100%; height: auto; font: 13px system-ui, sans-serif; fill: currentColor; }
svg .grid { stroke: var(--line); }
svg .pace { stroke: currentColor; stroke-dasharray: 4 4; opacity: 0.6; }
svg .stairs { fill: none; stroke: currentColor; opacity: 0.45; }
svg .end { text-anchor: end; }
svg .mid { text-anchor: middle; }
svg .name { font-weight: 700; stroke: Canvas; stroke-width: 3px; paint-order: stroke; }
svg .beaten { fill: none; stroke: var(--beaten); }
svg .surface { fill: var(--surface); fill-opacity: 0.75; stroke: var(--surface); }
svg .chord { fill: var(--chord); fill-opacity: 0.75; stroke: var(--chord); }
svg .best { stroke: currentColor; stroke-width: 3px; }
.legend i.surface { background: var(--surface); border-radius: 50%; }
.legend i.chord { background: var(--chord); border-radius: 50%; }
.legend i.beaten { border: 1px solid var(--beaten); border-radius: 50%; box-sizing: border-box; }
tr.beaten td { color: GrayText; }
@media (max-width: 760px) {
  .part { padding: 0.1rem 0.6rem 0.7rem; }
  .sides { grid-template-columns: minmax(0, 1fr); }
  .sides svg { font-size: 18px; }
  .thumbs { grid-template-columns: repeat(3, 1fr); }
}
)";

std::string answer(const Trade& trade, size_t k)
{
    const PartTrade& part = trade.parts[k];
    const Row& row = trade.rows[part.recommended];
    std::string html = "<p class=\"answer\"><b>" + escaped(name_of(row)) + "</b>: " + figures_text(row, k) +
                       (part.keeps_pace ? ".</p>\n" : ". No row is as fast as that; this is the fastest.</p>\n") +
                       "<pre>";
    for (const std::string& command : commands_of(trade, row)) html += escaped(command) + "\n";
    return html + "</pre>\n<p>In firmware: " + escaped(row.firmware) + ".</p>\n";
}

constexpr char kLegend[] =
    "<div class=\"key legend\"><span><i class=\"surface\"></i>surface field</span>"
    "<span><i class=\"chord\"></i>chord field</span><span><i class=\"beaten\"></i>beaten: another is faster and "
    "more accurate</span><span>area: flash</span><span>ring: recommended</span><span>dashes: wanted "
    "rate</span></div>\n";

std::string thumb(const tools::Picture& picture, const std::string& caption, bool is_best)
{
    return std::string("<figure") + (is_best ? " class=\"best\"" : "") + ">" + quality::image_tag(picture, caption) +
           "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

// All of one view.
std::string thumbs(const Trade& trade, size_t k, const quality::ReportData& report)
{
    const PartTrade& part = trade.parts[k];
    std::string html = "<div class=\"thumbs\">\n";
    for (size_t place = 0; place < part.front.size(); ++place) {
        const Row& row = trade.rows[part.front[place]];
        const std::string caption = std::to_string(place + 1) + ": " + name_of(row) + ", " +
                                    number(row.measured->mean.psnr_db, 1) + " dB, " +
                                    rate_text(row.parts[k].frames_per_second) + " fps";
        html += thumb(row.measured->pictures[0], caption, part.front[place] == part.recommended);
    }
    return html + thumb(report.references[0].picture, "path-traced", false) + "</div>\n";
}

std::string part_section(const Trade& trade, size_t k, const quality::ReportData& report)
{
    const std::string begin = "<section class=\"part\"><h2>" + escaped(pace_text(trade.parts[k].pace)) + "</h2>\n";
    if (trade.parts[k].front.empty()) return begin + "<p>No row fits its memory.</p></section>\n";
    return begin + answer(trade, k) + "<div class=\"sides\"><div>" + chart_of(trade, k) + kLegend + "</div>\n" +
           thumbs(trade, k, report) + "</div></section>\n";
}

bool is_on_a_front(const Trade& trade, size_t row)
{
    return std::any_of(
        trade.parts.begin(), trade.parts.end(),
        [&](const PartTrade& part) {
            return std::find(part.front.begin(), part.front.end(), row) != part.front.end();
        });
}

std::string cells_of(const PartFigures& figures)
{
    constexpr double kMega = 1e6;
    if (!figures.fits) return cell("does not fit") + cell(number(figures.instructions / kMega, 1));
    return cell(rate_text(figures.frames_per_second) +
                (figures.worst != figures.frames_per_second ? " (" + rate_text(figures.worst) + ")" : std::string())) +
           cell(number(figures.instructions / kMega, 1));
}

std::string table_row(const Trade& trade, size_t k)
{
    const Row& row = trade.rows[k];
    const quality::Figures& mean = row.measured->mean;
    std::string html = std::string("<tr") + (is_on_a_front(trade, k) ? "" : " class=\"beaten\"") + ">" +
                       cell(escaped(name_of(row))) + cell(number(mean.psnr_db, 2)) + cell(number(mean.ssim, 4)) +
                       cell(number(mean.flip, 4)) + cell(tools::byte_text(row.measured->flash_bytes)) +
                       cell(tools::byte_text(row.ram_bytes));
    for (const PartFigures& figures : row.parts) html += cells_of(figures);
    return html + "</tr>\n";
}

std::string table(const Trade& trade)
{
    std::string html =
        "<h2>All rows, the most accurate first</h2>\n<div class=\"wide\"><table><tr><th>what<th>PSNR dB<th>SSIM"
        "<th>FLIP<th>flash<th>RAM";
    for (const PartTrade& part : trade.parts)
        html += "<th>" + escaped(marked_title(*part.pace.chip)) + ", fps<th>M instructions";
    html += "</tr>\n";
    std::vector<size_t> order;
    for (size_t k = 0; k < trade.rows.size(); ++k) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return trade.rows[a].measured->mean.psnr_db > trade.rows[b].measured->mean.psnr_db;
    });
    for (const size_t k : order) html += table_row(trade, k);
    return html + "</table></div>\n";
}

constexpr char kModel[] =
    "<p>Accuracy and cost are of the same file, drawn by the same mode into 240 × 240 pixels of RGB565, on one core. "
    "Frame rates are modelled from instructions that were counted and from flash lines that the field misses, not "
    "measured; in brackets is the dearest of 200 poses. RAM is that of a frame and a stripe of 16 rows. Rates of a "
    "part with a * are estimated: its CPU has another instruction set than the one that was counted. The program takes "
    "flash besides: 17 to 27 kB of code.</p>\n";

}  // namespace

quality::PageLead lead_of(const Trade& trade, const quality::ReportData& report)
{
    std::string html;
    for (size_t k = 0; k < trade.parts.size(); ++k) html += part_section(trade, k, report);
    quality::PageLead lead = {
        "Speed against accuracy", kTradeStyle, html + table(trade) + kModel + "<h2>Accuracy in detail</h2>\n", {}};
    for (size_t k = 0; k < trade.rows.size(); ++k)
        if (is_on_a_front(trade, k)) lead.pictured.insert(trade.rows[k].field);
    return lead;
}

}  // namespace lumi::trade
