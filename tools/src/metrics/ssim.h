// SPDX-License-Identifier: MIT
// Computes structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE TIP 13(4), 2004.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// The side of SSIM's window; smaller pictures have no SSIM.
inline constexpr int kSsimWindow = 11;

// The mean of the SSIM map of the luma: 11×11 Gaussian window of sigma 1.5, K1 = 0.01, K2 = 0.03, dynamic range 255, no
// downsampling. Only windows that lie wholly inside count (the "valid" region); nothing is padded.
// Precondition: same_size(a, b), both sides at least kSsimWindow.
double ssim(const Picture& a, const Picture& b);

// The mean over the windows whose middle pixel is not zero in the mask; 1 if there is none.
double ssim(const Picture& a, const Picture& b, const Mask& mask);

}  // namespace lumi::tools
