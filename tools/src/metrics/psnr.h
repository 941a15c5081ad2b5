// SPDX-License-Identifier: MIT
// Computes the peak signal-to-noise ratio of two pictures, and a picture of their errors.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// 10·log10(255² / mean squared error over all three channels) in dB; infinity for identical pictures.
// Precondition: same_size(a, b), at least one pixel.
double psnr_db(const Picture& a, const Picture& b);

// Counts only the pixels where the mask is not zero. Precondition: it has the pictures' size and such a pixel.
double psnr_db(const Picture& a, const Picture& b, const Mask& mask);

// |a - b| per channel times kErrorGain, clamped: black where equal, brighter where worse.
// Precondition: same_size(a, b).
inline constexpr int kErrorGain = 4;
Picture error_picture(const Picture& a, const Picture& b);

}  // namespace lumi::tools
