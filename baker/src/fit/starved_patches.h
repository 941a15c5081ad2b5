// SPDX-License-Identifier: MIT
// Patches that hardly any path met.
#pragma once

#include "fit/fit_model.h"

namespace lumi::baker
{

// The texels of such patches are drawn to the mean colour of the patches around, with the force of half a path each, so
// that those which no path met at all are not black. `counts`: paths, by texel.
void fill_starved_patches(const FitShape& shape, const std::vector<uint32_t>& counts, std::vector<LevelColour>& texels);

}  // namespace lumi::baker
