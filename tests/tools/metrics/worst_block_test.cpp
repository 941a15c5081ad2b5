// SPDX-License-Identifier: MIT
#include "metrics/psnr.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace lumi::tools
{

TEST_CASE("the worst block is where most error lies, at the right and lower border too")
{
    const Picture truth(40, 36, {90, 90, 90});
    Picture picture = truth;
    CHECK(std::isinf(worst_block(picture, truth).psnr_db));
    picture.pixel(20, 3)[1] += 20;
    CHECK(worst_block(picture, truth).x == 16);
    picture.pixel(39, 35)[0] += 30;
    const Block worst = worst_block(picture, truth);
    CHECK(worst.x == 32);
    CHECK(worst.y == 32);
    const double mean_square = 30.0 * 30 / (3 * kBlockPx * kBlockPx);
    CHECK(worst.psnr_db == Approx(10 * std::log10(255 * 255 / mean_square)));
}

}  // namespace lumi::tools
