// SPDX-License-Identifier: MIT
// How good a picture is, in every measure of the report.
#pragma once

#include <vector>

#include "image/plane.h"

namespace lumi::quality
{

// The path-traced reference of a view, and where the scene covers it at all.
struct Reference {
    tools::Picture picture;
    tools::Mask mask;
};

// A picture that equals its reference counts as this many dB: means stay finite.
inline constexpr double kIdenticalDb = 99;

struct Figures {
    double psnr_db = 0, ssim = 0, cw_ssim = 0, flip = 0;
    double mask_psnr_db = 0, mask_ssim = 0;  // inside the mask; as the whole where it is empty
};

// Precondition: same_size(picture, reference.picture).
Figures figures_of(const tools::Picture& picture, const Reference& reference);

// The mean of each. Precondition: at least one.
Figures mean_of(const std::vector<Figures>& all);

}  // namespace lumi::quality
