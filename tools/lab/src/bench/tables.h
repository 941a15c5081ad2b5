// SPDX-License-Identifier: MIT
// The tables of the page about speed and accuracy, in Markdown. Combinations that were not measured read "–".
#pragma once

#include <string>
#include <vector>

#include "bench/baselines.h"
#include "bench/matrix.h"

namespace lumi::bench
{

// A row of a Markdown table, and the row of dashes below a heading of `columns` columns: the first left, others right.
std::string table_row(const std::vector<std::string>& cells);
std::string table_rule(size_t columns);
// "12.3"; "–" for null, "∞" for infinity.
std::string decimal_text(double value, int digits = 1);

inline const std::string kNotMeasured = "–";

// The renderers that a reader looks for first: cost and accuracy.
std::string glance_table(const Results& results);
// Instructions per covered pixel, generic view: mode and texel against core and span.
std::string cost_table(const Results& results);
// The same split into set-up and inner loop, for span 8 and 16 on M4 and M0+.
std::string split_table(const Results& results);
// PSNR and worst pixel per view and span; the same for every core.
std::string accuracy_table(const Results& results);
// Surface fields: instructions per covered pixel per core, generic view; PSNR and worst pixel per view; memory.
std::string surface_table(const SurfaceResults& surface);
// The same split into parts, for M4 and M0+.
std::string surface_split_table(const SurfaceResults& surface);
// Misses and frames per second per part, generic view.
std::string surface_chip_table(const SurfaceResults& surface);
// Flash for code and tables, stack.
std::string memory_table(const Results& results);
// Lines touched, missed and frames per second per part, generic view, span 16.
std::string chip_table(const Results& results);
// How the cost changes from the generic to the polar view at span 16.
std::string polar_table(const Results& results);
std::string baseline_cost_table(const Results& results, const std::vector<BaselineCost>& costs);
std::string likeness_table(const std::vector<Likeness>& pictures);

}  // namespace lumi::bench
