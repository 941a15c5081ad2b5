// SPDX-License-Identifier: MIT
// Packs view tables into the bits of the format: three gains a vertex, and one of 2^bits colours a node.
#pragma once

#include "fit/fit_solver.h"
#include "pack/surface_writer.h"

namespace lumi::baker
{

struct QuantisedViews {
    NodeColours colours;
    std::vector<ViewCode> views;  // by vertex
};

// At most so many bytes are planned for view tables, if there are to be any.
uint64_t planned_view_bytes(const PatchMesh& mesh, bool view_tables = true);
// The most bits of a code with which the tables of so many vertices fit into these bytes.
uint32_t code_bits_for(uint64_t bytes, uint32_t viewed);

// Returns the quantised view tables of the viewed vertices.
QuantisedViews quantised(const FitSums& sums, const FitModel& model, const std::vector<uint8_t>& viewed, uint32_t bits);
// The levels that a reader makes of them, 0 where there is no table.
std::vector<LevelColour> decoded(const QuantisedViews& views);

}  // namespace lumi::baker
