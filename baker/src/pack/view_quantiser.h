// SPDX-License-Identifier: MIT
// View tables in the bits of the format: a gain a vertex, and one of 16 colours a node.
#pragma once

#include "fit/fit_solver.h"
#include "pack/surface_writer.h"

namespace lumi::baker
{

struct QuantisedViews {
    NodeColours colours;
    std::vector<ViewCode> views;  // by vertex
};

// Vertices whose view table changes what is shown by more than about a level.
std::vector<uint8_t> viewed_vertices(const FitSums& sums, const FitModel& model);

// The quantised view tables of the viewed vertices.
QuantisedViews quantised(const FitSums& sums, const FitModel& model, const std::vector<uint8_t>& viewed);
// What a reader makes of them, 0 where there is no table.
std::vector<LevelColour> decoded(const QuantisedViews& views);

}  // namespace lumi::baker
