// SPDX-License-Identifier: MIT
// How good a picture is, in every measure of the report.
#pragma once

#include <vector>

#include "image/plane.h"

namespace lumi::quality
{

// The path-traced truth of a view, and where the scene covers it at all.
struct Truth {
    tools::Picture picture;
    tools::Mask mask;
};

// A picture that equals its truth counts as this many dB: means stay finite.
inline constexpr double kIdenticalDb = 99;

struct Figures {
    double psnr_db = 0, ssim = 0, cw_ssim = 0, flip = 0;
    double mask_psnr_db = 0, mask_ssim = 0;  // inside the mask; as the whole where it is empty
};

// Precondition: same_size(picture, truth.picture).
Figures figures_of(const tools::Picture& picture, const Truth& truth);

// The mean of each. Precondition: at least one.
Figures mean_of(const std::vector<Figures>& all);

}  // namespace lumi::quality
