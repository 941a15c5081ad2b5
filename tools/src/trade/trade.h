// SPDX-License-Identifier: MIT
// Finds what each file costs on each part, and what it shows, drawn by the same mode.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planner/speed.h"
#include "quality/report_data.h"

namespace lumi::trade
{

// Which ways to draw are worth a look: those that no other one beats in speed and in accuracy at once.

struct Point {
    double frames_per_second, psnr_db;
    bool is_possible = true;  // impossible ones neither stand on the front nor beat others
};

// Accuracy that differs by less is the same.
inline constexpr double kSameDb = 0.01;

// The places of those that no other one beats, the fastest first. Of equals the first one stands for all.
std::vector<size_t> front_of(const std::vector<Point>& points);

// The figures are of frames of 240 × 240 pixels of RGB565 on one core.
struct PartFigures {
    double frames_per_second, worst, instructions;  // worst: of the dearest pose; instructions: a frame
    bool fits;                                      // RAM in the longest piece of the part, the file in its flash
};

// Describes a file that is drawn by a mode.
struct Row {
    const quality::Measured* measured;
    bool is_surface;
    std::string field;           // as the command was told it
    std::string bake;            // options of `lumi bake` for a field of that size; empty: the field is the caller's
    std::string mode;            // "antialiased", "linear, S = 8"
    std::string render_options;  // `lumi render` draws so by these
    std::string firmware;        // how the view that `lumi embed` writes draws so
    uint64_t ram_bytes;          // a view and a stripe of 16 rows (planner/speed.h)
    std::vector<PartFigures> parts;  // in the order of Trade::parts; empty for modes that no model knows
};

struct PartTrade {
    planner::Pace pace;
    std::vector<size_t> front;  // rows, the fastest first
    size_t recommended = 0;     // on the front: the most accurate that keeps the pace, else the fastest
    bool keeps_pace = false;
};

struct Trade {
    std::string scene;
    std::vector<Row> rows;         // the fields of the report, then its variants
    std::vector<PartTrade> parts;  // whose front is empty if nothing fits them
};

using Files = std::vector<std::unique_ptr<tools::FieldFile>>;

// By the path of a field, Row::bake.
using Bakes = std::map<std::string, std::string>;

// All rows of the report, whose fields are `files`. The report must outlive what is returned.
Trade trade_of(const quality::ReportData& report, const Files& files, const std::vector<planner::Pace>& paces,
               const Bakes& bakes = {});

// By which chord fields are drawn unless modes are named.
std::vector<quality::DrawMode> usual_modes();

// Says what to type for a row, each a line. Fields that are still to be baked have the scene's name.
std::vector<std::string> commands_of(const Trade& trade, const Row& row);

}  // namespace lumi::trade
