// SPDX-License-Identifier: MIT
#include "metrics/worst_block.h"

#include <algorithm>

#include "metrics/psnr.h"

namespace lumi::tools
{

namespace
{

// A part of the picture; black where the block leaves it.
Picture block_of(const Picture& picture, int x, int y)
{
    Picture block(kBlockPx, kBlockPx);
    const int width = std::min(kBlockPx, picture.width_px - x), height = std::min(kBlockPx, picture.height_px - y);
    for (int row = 0; row < height; ++row) std::copy_n(picture.pixel(x, y + row), 3 * width, block.pixel(0, row));
    return block;
}

}  // namespace

Block worst_block(const Picture& a, const Picture& b)
{
    check_precondition(same_size(a, b) && !a.rgb.empty(), "pictures of two sizes cannot be compared");
    Block worst = {0, 0, psnr_db(block_of(a, 0, 0), block_of(b, 0, 0))};
    for (int y = 0; y < a.height_px; y += kBlockPx) {
        for (int x = 0; x < a.width_px; x += kBlockPx) {
            const double db = psnr_db(block_of(a, x, y), block_of(b, x, y));
            if (db < worst.psnr_db) worst = {x, y, db};
        }
    }
    return worst;
}

}  // namespace lumi::tools
