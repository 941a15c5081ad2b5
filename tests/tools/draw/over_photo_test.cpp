// SPDX-License-Identifier: MIT
#include "draw/views.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace lumi::tools
{

TEST_CASE("over a photograph: every colour, coverage and background blends to within one level of the exact sum")
{
    // Premultiplied c with coverage a over black shows c, over white c + (255 - a): as core's blend rounds them.
    double worst = 0;
    for (int a = 0; a <= 255; a += 5)
        for (int c = 0; c <= a; c += 5)
            for (int back = 0; back <= 255; back += 15) {
                const auto level = [](int v) { return static_cast<uint8_t>(v); };
                const Picture black(1, 1, {level(c), 0, 0}), white(1, 1, {level(c + 255 - a), 255, 255}),
                    photo(1, 1, {level(back), level(back), 7});
                const Picture result = over_photo(black, white, photo);
                worst = std::max(worst, std::abs(result.rgb[0] - (c + (255 - a) * back / 255.0)));
                CHECK(result.rgb[2] == 7);  // nothing covers it there
            }
    CHECK(worst <= 0.5);
}

}  // namespace lumi::tools
