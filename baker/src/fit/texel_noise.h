// SPDX-License-Identifier: MIT
// Takes noise out of fitted texels.
#pragma once

#include <vector>

#include "fit/encoded_tone.h"

namespace lumi::baker
{

// Smooths a rectangle `width` wide. `variances` are those of the fitted texels, levels² a channel; negative where no
// path met a texel. Each texel is drawn to its neighbours by as much as neighbours around there differ less than noise
// alone makes them differ. So noise leaves where the picture is smooth, edges stay, and what no path met is filled.
void smooth_noise(LevelColour* texels, const std::vector<double>& variances, uint32_t width);

}  // namespace lumi::baker
