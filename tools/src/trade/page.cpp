// SPDX-License-Identifier: MIT
#include "trade/page.h"

#include <algorithm>

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

// This is how the trade looks on the report page.
constexpr char kTradeStyle[] = R"(
.part { border: 1px solid var(--line); border-radius: 10px; padding: 0.2rem 1rem 1rem; margin: 1rem 0; }
.part h2 { margin-top: 0.7rem; }
.answer { font-size: 1.1rem; max-width: none; }
.part pre { overflow-x: auto; background: var(--soft); border-radius: 6px; padding: 0.5rem 0.7rem; margin: 0.5rem 0;
  font-size: 0.85rem; }
.thumbs { display: grid; grid-template-columns: repeat(auto-fill, minmax(108px, 1fr)); gap: 0.5rem; }
.thumbs .best { outline: 3px solid #2a6fc9; }
tr.beaten td { color: GrayText; }
@media (max-width: 760px) {
  .part { padding: 0.1rem 0.6rem 0.7rem; }
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

std::string thumb(const tools::Picture& picture, const std::string& caption, bool is_best)
{
    return std::string("<figure") + (is_best ? " class=\"best\"" : "") + ">" + quality::image_tag(picture, caption) +
           "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

// The front of a part, from the fastest to the most accurate: all of one view.
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
    return begin + answer(trade, k) + thumbs(trade, k, report) + "</section>\n";
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
