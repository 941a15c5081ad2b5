// SPDX-License-Identifier: MIT
// Complex wavelet structural similarity: Sampat, Wang, Gupta, Bovik, Markey, "Complex Wavelet Structural Similarity: A
// New Image Similarity Index", IEEE TIP 18(11), 2009. Small shifts and turns rotate the phases of neighbouring
// coefficients alike and hardly lower it; noise, blur and false structure scramble them.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

inline constexpr int kCwSsimWindow = 7;
inline constexpr int kCwSsimMaxLevels = 6;

// Over each 7×7 window of each band of the luma's steerable pyramid (16 orientations):
//     (2·|mean(a·conj b)| + K) / (mean|a|² + mean|b|² + K)
// averaged over all windows wholly inside a band, then over all bands. Levels: 6, or as many as have room for a window.
// K = 1 squared grey level: what differs by less than one step of an 8-bit picture, flat backgrounds above all, counts
// as alike instead of dividing rounding noise by rounding noise.
// Precondition: same_size(a, b), both sides at least kCwSsimWindow.
double cw_ssim(const Picture& a, const Picture& b);

}  // namespace lumi::tools
