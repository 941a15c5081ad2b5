// SPDX-License-Identifier: MIT
#include "trade/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "quality/page.h"
#include "terminal/text.h"

namespace lumi::trade
{

using quality::number;

namespace
{

using Json = nlohmann::ordered_json;

double rounded(double value, double places)
{
    return std::round(value * places) / places;
}

std::string part_text(const Trade& trade, size_t k)
{
    const PartTrade& part = trade.parts[k];
    if (part.front.empty()) return pace_text(part.pace) + ": no row fits its memory\n";
    const Row& row = trade.rows[part.recommended];
    std::string text = pace_text(part.pace) + (part.keeps_pace ? ": " : ": too fast for it; the fastest is ") +
                       name_of(row) + ": " + figures_text(row, k) + "\n";
    for (const std::string& command : commands_of(trade, row)) text += "  " + command + "\n";
    return text + "  in firmware: " + row.firmware + "\n";
}

Json json_of(const PartFigures& figures, bool is_on_front)
{
    constexpr double kPlaces = 1e3;
    return {{"frames_per_second", rounded(figures.frames_per_second, kPlaces)},
            {"worst", rounded(figures.worst, kPlaces)},
            {"instructions", std::llround(figures.instructions)},
            {"fits", figures.fits},
            {"on_front", is_on_front}};
}

bool is_on(const std::vector<size_t>& front, size_t row)
{
    return std::find(front.begin(), front.end(), row) != front.end();
}

Json row_json(const Trade& trade, size_t k)
{
    constexpr double kPlaces = 1e4;
    const Row& row = trade.rows[k];
    const quality::Measured& m = *row.measured;
    Json json = {{"field", row.field},
                 {"layout", row.is_surface ? "surface" : "chord"},
                 {"mode", row.mode},
                 {"flash_bytes", m.flash_bytes},
                 {"ram_bytes", row.ram_bytes},
                 {"psnr_db", rounded(m.mean.psnr_db, kPlaces)},
                 {"ssim", rounded(m.mean.ssim, kPlaces)},
                 {"flip", rounded(m.mean.flip, kPlaces)}};
    for (size_t part = 0; part < row.parts.size(); ++part)
        json["parts"][trade.parts[part].pace.chip->key] = json_of(row.parts[part], is_on(trade.parts[part].front, k));
    return json;
}

Json part_json(const Trade& trade, const PartTrade& part)
{
    Json json = {{"part", part.pace.chip->key}, {"wanted", part.pace.frames_per_second}, {"front", part.front}};
    if (part.front.empty()) return json;
    json["recommended"] = part.recommended;
    json["keeps_pace"] = part.keeps_pace;
    json["commands"] = commands_of(trade, trade.rows[part.recommended]);
    json["firmware"] = trade.rows[part.recommended].firmware;
    return json;
}

}  // namespace

std::string rate_text(double frames_per_second)
{
    constexpr double kWhole = 20;
    return number(frames_per_second, frames_per_second < 1 ? 2 : frames_per_second < kWhole ? 1 : 0);
}

std::string name_of(const Row& row)
{
    return std::filesystem::path(row.field).filename().string() + ", " + row.mode;
}

std::string figures_text(const Row& row, size_t part)
{
    const PartFigures& figures = row.parts[part];
    const bool varies = figures.worst != figures.frames_per_second;
    return number(row.measured->mean.psnr_db, 1) + " dB at " + rate_text(figures.frames_per_second) +
           " frames a second" + (varies ? " (dearest pose " + rate_text(figures.worst) + ")" : "") + ", " +
           tools::byte_text(row.measured->flash_bytes) + " of flash, " + tools::byte_text(row.ram_bytes) + " of RAM";
}

std::string pace_text(const planner::Pace& pace)
{
    char text[80];
    std::snprintf(text, sizeof text, "%s at %g frames a second", marked_title(*pace.chip).c_str(),
                  pace.frames_per_second);
    return text;
}

std::string text_of(const Trade& trade)
{
    std::string text;
    for (size_t k = 0; k < trade.parts.size(); ++k) text += part_text(trade, k);
    return text;
}

std::string with_trade(const std::string& report, const Trade& trade)
{
    Json json = Json::parse(report), parts = Json::array(), rows = Json::array();
    for (const PartTrade& part : trade.parts) parts.push_back(part_json(trade, part));
    for (size_t k = 0; k < trade.rows.size(); ++k) rows.push_back(row_json(trade, k));
    json["trade"] = {{"pixels", "240 x 240, RGB565, one core"}, {"parts", parts}, {"rows", rows}};
    constexpr int kIndent = 2;
    return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lumi::trade
