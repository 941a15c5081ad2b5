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

TEST_CASE("over nothing: every colour and coverage, laid over any background, is drawn over it to within a level")
{
    double worst = 0;
    for (int a = 0; a <= 255; a += 5)
        for (int c = 0; c <= a; c += 5) {
            const auto level = [](int v) { return static_cast<uint8_t>(v); };
            const Picture alone = over_nothing(Picture(1, 1, {level(c), 0, level(a)}),
                                               Picture(1, 1, {level(c + 255 - a), level(255 - a), 255}));
            CHECK(alone.alpha[0] == a);
            for (int back = 0; back <= 255; back += 15) {
                const double shown = (alone.rgb[0] * a + back * (255 - a)) / 255.0;
                worst = std::max(worst, std::abs(shown - (c + (255 - a) * back / 255.0)));
            }
        }
    CHECK(worst <= 0.5);
}

TEST_CASE("over nothing: a highlight on clear glass stays as bright as it is over black")
{
    const Picture alone = over_nothing(Picture(1, 1, {200, 180, 160}), Picture(1, 1, {255, 255, 255}));
    for (size_t k = 0; k < 3; ++k)
        CHECK(alone.rgb[k] * alone.alpha[0] / 255.0 == Approx(200 - 20.0 * static_cast<double>(k)).margin(1));
}

}  // namespace lumi::tools
