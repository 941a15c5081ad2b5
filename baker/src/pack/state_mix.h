// SPDX-License-Identifier: MIT
// From the states of the light that were fitted one by one to what a field shows of all of them together.
#pragma once

#include "fit/fit_model.h"
#include "pack/view_quantiser.h"

namespace lumi::baker
{

// The levels of all states together; `levels` and `factors` by state.
LevelColour levels_of(const Rgb8& colour);
LevelColour mixed(const std::vector<LevelColour>& levels, const std::vector<Rgb>& factors);
std::vector<LevelColour> mixed_texels(const LevelsOfStates& states);

// Takes the light of `base` away from texels and view tables of `model`.
void take_away(const FitShape& shape, const FitModel& base, FitModel& model);

// By vertex: the entry of the palettes that is nearest to the mean of the texels about it.
std::vector<uint8_t> mean_entries(const FitShape& shape, const LevelsOfStates& states,
                                  const std::vector<PaletteColours>& palettes);

// The view tables of all states together, with the codes that they share. `views`, `palettes` by state.
QuantisedViews mixed_views(const std::vector<QuantisedViews>& views, const std::vector<PaletteColours>& palettes,
                           const std::vector<Rgb>& factors, const std::vector<uint8_t>& means);

}  // namespace lumi::baker
