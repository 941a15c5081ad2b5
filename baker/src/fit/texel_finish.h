// SPDX-License-Identifier: MIT
// Texels as they are shown: what was summed along straight lines is encoded, and noise is taken out.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/encoded_tone.h"
#include "fit/fit_sums.h"

namespace lumi::baker
{

// Takes noise out of fitted texels.

// Smooths a rectangle `width` wide. `variances` are those of the fitted texels, levels² a channel; negative where no
// path met a texel. Each texel is drawn to its neighbours by as much as neighbours around there differ less than noise
// alone makes them differ. So noise leaves where the picture is smooth, edges stay, and what no path met is filled.
void smooth_noise(LevelColour* texels, const std::vector<double>& variances, uint32_t width);

// The light of a texel, as far as it is known.
struct TexelLight {
    ToneLine line;       // about which its paths were summed: around the mean of what was expected of them
    LevelColour target;  // the mean of the sums; without paths the texel itself
    Rgb light;           // the mean radiance
    LevelColour tables;  // the mean of what view tables add
    double scatter;      // sum over paths of squares from what was predicted, levels² a channel
    uint32_t paths;
};

// The texels of a rectangle `width` wide. Where it is smooth, the mean of the light stays what it is, however noisy
// texels are. Encoded means of few paths are darker than the encoded mean of many, and so they would be if each was
// trusted by its own scatter: those that a bright path met scatter most. A rectangle that no path met keeps its texels.
std::vector<LevelColour> finished(const EncodedTone& tone, const std::vector<TexelLight>& light, uint32_t width);

// All texels of a model that fit such sums. Patches that few paths met are drawn to those around.
void finish_texels(const FitSums& sums, const EncodedTone& tone, FitModel& model);

}  // namespace lumi::baker
