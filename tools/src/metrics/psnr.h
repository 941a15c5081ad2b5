// SPDX-License-Identifier: MIT
// Peak signal-to-noise ratio.
#pragma once

#include "image/plane.h"

namespace lumi::tools
{

// 10·log10(255² / mean squared error over all three channels) in dB; infinity for identical pictures.
// Precondition: same_size(a, b), at least one pixel.
double psnr_db(const Picture& a, const Picture& b);

// The same over the pixels where the mask is not zero. Precondition: it has the pictures' size and such a pixel.
double psnr_db(const Picture& a, const Picture& b, const Mask& mask);

}  // namespace lumi::tools
