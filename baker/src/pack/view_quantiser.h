// SPDX-License-Identifier: MIT
// Packs view tables into the bits of the format: three gains a vertex, and one of 2^bits colours a node.
#pragma once

#include "fit/fit_solver.h"
#include "pack/surface_writer.h"

namespace lumi::baker
{

inline constexpr float kGainUnit = 64;
inline constexpr float kMostLevel = 127;  // the largest level of a channel, either sign

struct QuantisedViews {
    NodeColours colours;
    std::vector<ViewCode> views;  // by vertex
};

// At most so many bytes are planned for view tables, if there are to be any, of so many states of the light.
uint64_t planned_view_bytes(const PatchMesh& mesh, bool view_tables = true, uint32_t states = 1);
// Return what so many gloss maps add to a file, and how much more that is than view tables leave them: these have
// shorter codes beside maps.
uint64_t gloss_file_bytes(const PatchMesh& mesh, size_t maps);
uint64_t gloss_bytes_beyond_tables(const PatchMesh& mesh, size_t maps);
// The most bits of a code with which the tables of so many vertices fit into these bytes.
uint32_t code_bits_for(uint64_t bytes, uint32_t viewed, uint32_t states = 1);

// One state of the light asks this of view tables; borrowed.
struct ViewLayer {
    const FitSums& sums;
    const FitModel& model;
    float times = 1;  // what its levels count
};

// Returns the quantised view tables of the viewed vertices, by state. Codes are the same in all.
std::vector<QuantisedViews> quantised(const std::vector<ViewLayer>& layers, const std::vector<uint8_t>& viewed,
                                      uint32_t bits);
// The levels that a reader makes of them, 0 where there is no table.
std::vector<LevelColour> decoded(const QuantisedViews& views);

}  // namespace lumi::baker
