// SPDX-License-Identifier: MIT
// Texels that few paths met.
#pragma once

#include <vector>

#include "surface/encoded_tone.h"

namespace lumi::baker
{

// Of a rectangle `width` wide: each texel is drawn to its neighbours with the force of a few paths, so that those which
// no path met are filled from around and those which many met stay.
void smooth_starved(LevelColour* texels, const std::vector<uint32_t>& counts, uint32_t width);

}  // namespace lumi::baker
