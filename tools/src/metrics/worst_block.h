// SPDX-License-Identifier: MIT
// Where two pictures differ most: means hide a hole or a splinter.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

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
