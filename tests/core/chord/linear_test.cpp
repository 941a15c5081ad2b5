// SPDX-License-Identifier: MIT
// A core's own loops through the lattice's cells against the loop that every core has: the same bits, of spans and of
// tiles.
#include <catch2/catch.hpp>
#include <cstring>
#include <random>
#include <vector>

#include "lumi/background.h"
#include "lumi/chord/detail/linear.h"
#include "lumi/chord/detail/one_tap.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int kSpans = 500;
#else
constexpr int kSpans = 5000;
#endif
constexpr int32_t kPixels = 16;
constexpr int32_t kStride = 6;  // rows overlap, so that all addresses lie in one small buffer
// Cells of a span are less than 12 from (0, 0) along each axis, and reach one farther.
constexpr int32_t kMostIndex = 13 * (233 + 377);
constexpr int32_t kMiddle = kMostIndex * (kStride + 3) + kStride;

int32_t between(std::minstd_rand& random, int32_t low, int32_t high)
{
    return std::uniform_int_distribution<int32_t>(low, high)(random);
}

// Either kind of cell may begin within the span's own; without flips all are taken for the same kind.
CellLine random_side(std::minstd_rand& random, bool may_flip)
{
    CellLine side{};
    side.u_q16 = between(random, -(4 << 16), 4 << 16);
    side.v_q16 = between(random, -(4 << 16), 4 << 16);
    side.du_q16 = between(random, -30000, 30000);
    side.dv_q16 = between(random, -30000, 30000);
    const int32_t sign = between(random, 0, 1) != 0 ? 1 : -1;
    side.first = 233 * (between(random, 0, 1) != 0 ? sign : -sign);
    side.second = 377 * sign;
    side.flip = between(random, -2000, 2000);
    side.flip_mask = -between(random, 0, 1);
    side.uniform = !may_flip;
    return side;
}

LineChange random_down(std::minstd_rand& random)
{
    return {between(random, -20000, 20000), between(random, -20000, 20000), between(random, -400, 400),
            between(random, -400, 400)};
}

// Pixels of three bytes, which show more of a sum than packed colours do.
using Pixel = PixelRgb888;
struct Pixels {
    uint8_t scanline[kTileHeight][kPixels * Pixel::kBytes] = {};
};

template <bool kFlips, class Texel, class Background>
void compare(const Field& field, const Background& background, std::minstd_rand& random)
{
    for (int k = 0; k < kSpans; ++k) {
        CellLine origins = random_side(random, kFlips);
        CellLine directions = random_side(random, kFlips);
        const LineChange down[] = {random_down(random), random_down(random)};
        const int32_t length = between(random, 1, kPixels);
        const int32_t first = between(random, 0, kTileHeight - 1);
        const TileScanlines tile = {first, between(random, 1, kTileHeight - first), sizeof(Pixels::scanline[0]),
                                    down[0], down[1]};
        Pixels every, own;
        const auto piece = [&](Pixels& pixels) {
            return CellPiece<Background>{field,   background, pixels.scanline[0],          length,
                                         origins, directions, k % 2 != 0 ? &tile : nullptr};
        };
        const TileScanlines* const all = can_follow_tile(piece(every)) ? &tile : nullptr;
        draw_both_sides<kFlips, Texel, Pixel>(piece(every), all);
        draw_cells<Texel, Pixel>(piece(own), all);
        INFO("span " << k << " of " << Texel::kName);
        REQUIRE(std::memcmp(every.scanline, own.scanline, sizeof(every.scanline)) == 0);
    }
}

template <class Texel>
void compare_loops()
{
    std::minstd_rand random(7);
    std::vector<uint32_t> words(2 * static_cast<size_t>(kMiddle) / 4 + 4);
    for (uint32_t& word : words) word = static_cast<uint32_t>(random()) * 2654435761u;
    std::vector<uint32_t> palette(256);
    for (uint32_t& entry : palette) entry = static_cast<uint32_t>(random()) * 2654435761u;
    Field field;
    field.texel_format = Texel::kFormat;
    field.row_stride_bytes = kStride;
    field.texels = reinterpret_cast<const uint8_t*>(words.data()) + kMiddle / 4 * 4;
    field.palette = reinterpret_cast<const uint8_t*>(palette.data());
    compare<false, Texel>(field, OverBlack{}, random);
    compare<true, Texel>(field, OverBlack{}, random);
}

}  // namespace

TEST_CASE("a core's own loop draws a span as the common one does, of every texel format", "[span]")
{
    compare_loops<TexelLuma8>();
    compare_loops<TexelPalette8>();
    compare_loops<TexelRgb888>();
    compare_loops<TexelRgb565>();
}
