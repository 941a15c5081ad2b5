// SPDX-License-Identifier: MIT
#include "trade/trade.h"

#include <algorithm>
#include <filesystem>

#include "draw/draw_surface.h"
#include "planner/speed.h"
#include "terminal/text.h"

namespace lumi::trade
{

std::vector<size_t> front_of(const std::vector<Point>& points)
{
    std::vector<size_t> order;
    for (size_t k = 0; k < points.size(); ++k)
        if (points[k].is_possible) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        const Point &x = points[a], &y = points[b];
        return x.frames_per_second != y.frames_per_second ? x.frames_per_second > y.frames_per_second
                                                          : x.psnr_db > y.psnr_db;
    });
    std::vector<size_t> front;
    for (const size_t k : order)
        if (front.empty() || points[k].psnr_db >= points[front.back()].psnr_db + kSameDb) front.push_back(k);
    return front;
}

namespace
{

using quality::Measured;
using tools::FieldFile;
using tools::Mode;

// Counted are spans of 4, 8 and 16 pixels, and the paper's kernel of 5 points a side.
bool is_modelled(const tools::DrawSettings& chord)
{
    return (chord.span_px == 0 || chord.span_px >= 4) &&
           (chord.mode != Mode::paper || chord.neighbours == tools::kDefaultNeighbours);
}

std::vector<planner::PartRate> rates_of(const FieldFile& file, const quality::Way& way)
{
    if (file.is_surface()) return planner::surface_rates(file.surface(), way.surface.mode);
    if (!is_modelled(way.chord)) return {};
    return planner::chord_rates(file.field(), way.chord.mode, way.chord.span_px);
}

// Names the policy of the view that `lumi embed` writes.
const char* policy_of(SurfaceMode mode)
{
    switch (mode) {
        case SurfaceMode::one_sample:
            return "lumi::SurfaceMode::one_sample";
        case SurfaceMode::antialiased:
            return "lumi::SurfaceMode::antialiased";
        case SurfaceMode::two_by_two:
            break;
    }
    return "lumi::SurfaceMode::two_by_two";
}

const char* policy_of(Mode mode)
{
    constexpr const char* kPolicies[] = {"lumi::Nearest", "lumi::Linear", "lumi::Paper"};
    return kPolicies[static_cast<size_t>(mode)];
}

void set_words(Row& row, const quality::Way& way)
{
    row.mode = row.is_surface ? tools::name_of(way.surface.mode) : tools::name_of(way.chord.mode);
    row.render_options = "--mode " + row.mode;
    row.firmware = std::string("policy ") + (row.is_surface ? policy_of(way.surface.mode) : policy_of(way.chord.mode));
    if (row.is_surface) return;
    const std::string neighbours = std::to_string(way.chord.neighbours), span = std::to_string(way.chord.span_px);
    if (way.chord.mode == Mode::paper) {
        row.mode += neighbours;
        row.render_options += " --neighbours " + neighbours;
        row.firmware += "<" + neighbours + ">";
    }
    const bool is_exact = way.chord.span_px == 0;
    row.mode += is_exact ? ", exact" : ", S = " + span;
    row.firmware += is_exact ? ", lumi::ExactChordDrawing" : ", spans of " + span + " pixels";
    if (!is_exact) row.render_options += " --span " + span;
}

bool fits(const planner::Chip& chip, const Row& row)
{
    return row.ram_bytes <= chip.ram_bytes && (chip.flash_bytes == 0 || row.measured->flash_bytes <= chip.flash_bytes);
}

Row row_of(const Measured& measured, const FieldFile& file, const std::vector<planner::Pace>& paces)
{
    Row row = {&measured, file.is_surface(), file.path(), "", "", "", "", 0, {}};
    row.ram_bytes = planner::ram_of(file, measured.way.surface.mode, {}).all();
    set_words(row, measured.way);
    const std::vector<planner::PartRate> rates = rates_of(file, measured.way);
    for (const planner::Pace& pace : paces)
        for (const planner::PartRate& rate : rates)
            if (rate.chip == pace.chip)
                row.parts.push_back({rate.mean, rate.worst, rate.instructions, fits(*rate.chip, row)});
    return row;
}

// Spans of a field that they refuse are exact pixels once more.
bool is_repeated(const Measured& measured, const FieldFile& file)
{
    return !file.is_surface() && measured.way.chord.span_px > 1 && !fits_spans(file.field());
}

PartTrade part_of(const planner::Pace& pace, size_t k, const std::vector<Row>& rows)
{
    std::vector<Point> points;
    for (const Row& row : rows)
        points.push_back(row.parts.empty()
                             ? Point{0, 0, false}
                             : Point{row.parts[k].frames_per_second, row.measured->mean.psnr_db, row.parts[k].fits});
    PartTrade part = {pace, front_of(points)};
    if (part.front.empty()) return part;
    part.recommended = part.front.front();
    for (const size_t row : part.front)
        if (points[row].frames_per_second >= pace.frames_per_second) {
            part.recommended = row;
            part.keeps_pace = true;
        }
    return part;
}

}  // namespace

std::vector<quality::DrawMode> usual_modes()
{
    std::vector<quality::DrawMode> modes;
    for (const char* word : {"nearest/16", "nearest/8", "linear/16", "linear/8", "linear/4", "nearest", "paper5"})
        modes.push_back(*quality::parse_draw_mode(word));
    return modes;
}

Trade trade_of(const quality::ReportData& report, const Files& files, const std::vector<planner::Pace>& paces,
               const Bakes& bakes)
{
    Trade trade;
    trade.scene = report.scene;
    for (const std::vector<Measured>* all : {&report.fields, &report.variants})
        for (const Measured& measured : *all) {
            const auto of_name = [&](const auto& file) { return file->path() == measured.name; };
            const FieldFile& file = **std::find_if(files.begin(), files.end(), of_name);
            if (is_repeated(measured, file)) continue;
            trade.rows.push_back(row_of(measured, file, paces));
            if (const auto bake = bakes.find(file.path()); bake != bakes.end()) trade.rows.back().bake = bake->second;
        }
    for (size_t k = 0; k < paces.size(); ++k) trade.parts.push_back(part_of(paces[k], k, trade.rows));
    return trade;
}

std::vector<std::string> commands_of(const Trade& trade, const Row& row)
{
    const std::string stem = std::filesystem::path(row.bake.empty() ? row.field : trade.scene).stem().string();
    const std::string field = row.bake.empty() ? row.field : stem + ".lumi";
    const auto word = tools::shell_word;
    std::vector<std::string> commands;
    if (!row.bake.empty()) commands.push_back("lumi bake " + word(trade.scene) + " -o " + word(field) + " " + row.bake);
    commands.push_back("lumi render " + word(field) + " -o " + word(stem + ".png") + " " + row.render_options);
    commands.push_back("lumi embed " + word(field) + " -o " + word(stem + ".S"));
    return commands;
}

}  // namespace lumi::trade
