// SPDX-License-Identifier: MIT
// Peak signal-to-noise ratio, and where two pictures differ most: means hide a hole or a splinter.
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

inline constexpr int kBlockPx = 16;

struct Block {
    int x = 0, y = 0;    // its top left pixel
    double psnr_db = 0;  // infinity for identical pictures
};

// The block of kBlockPx × kBlockPx pixels with the largest squared error, of all that lie on that grid; those at the
// right and lower border hold fewer pixels, and their error counts as that of whole ones.
// Precondition: same_size(a, b), at least one pixel.
Block worst_block(const Picture& a, const Picture& b);

}  // namespace lumi::tools
