// SPDX-License-Identifier: MIT
// Where light paths are worth most.
#pragma once

#include "fit/fit_sums.h"

namespace lumi::baker
{

// By patch, the chance that an extra line (fit/extra_lines.h) goes there: none where empty, else numbers that sum to 1.
// `pilot` holds the light of `pilot_lines` lines through the sphere. As many extra light paths as `share` of the
// pilot's would bring the sum of all texels' variances to its least: every texel counts alike, however seldom it is
// seen.
std::vector<float> extra_chances(const FitSums& pilot, double pilot_lines, double share);

}  // namespace lumi::baker
