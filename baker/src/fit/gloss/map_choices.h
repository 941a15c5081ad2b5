// SPDX-License-Identifier: MIT
// Which patches share a gloss map: those of a material, or those that mirror about as much. A texture atlas puts
// lacquer, steel and rubber into one material, and a car's paint may be ten.
#pragma once

#include "fit/gloss/equations.h"

namespace lumi::baker
{

// By patch, as all choices: 0, or its map from 1 on. One map for all that is smooth.
std::vector<uint8_t> choices_of_one(const GlossLines& all);

// The materials that most lines meet get a map each.
std::vector<uint8_t> choices_by_material(const GlossLines& all, size_t materials, uint32_t most);

// Splits maps where patches of the same map show it more and less strongly than it is, as long as that pays and maps
// are at most so many. `levels` of lines are less the mean of each texel.
std::vector<uint8_t> split_choices(const GlossEquations& equations, const GlossColours& unknowns,
                                   const GlossColours& levels, const std::vector<GlossLine>& lines,
                                   std::vector<uint8_t> choices, uint32_t most);

// Each patch that has a map takes that of `maps` (numbers from 1 on) which leaves least to its lines, or none; patches
// beside each other rather the same.
std::vector<uint8_t> choices_among(const std::vector<uint8_t>& maps, const GlossEquations& equations,
                                   const GlossColours& unknowns, GlossColours levels,
                                   const std::vector<GlossLine>& lines, const PatchMesh& mesh,
                                   std::vector<uint8_t> choices);

}  // namespace lumi::baker
