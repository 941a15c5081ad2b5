// SPDX-License-Identifier: MIT
// The fast loops of one tap against the loop that asks for every texel: the same texels.
#include "lumi/chord/detail/one_tap.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <random>
#include <vector>

#include "lumi/background.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

constexpr int kSpans = 1000;
constexpr int32_t kPixels = 16;
constexpr uint32_t kPoints = 20000;
constexpr uint32_t kStride = 6;  // rows overlap, so that all addresses lie in one small buffer

int32_t between(std::minstd_rand& random, int32_t low, int32_t high)
{
    return std::uniform_int_distribution<int32_t>(low, high)(random);
}

// Cells less than 12 from the middle of the lattice along each axis.
CellLine random_line(std::minstd_rand& random)
{
    CellLine line{};
    line.u_q16 = between(random, -(4 << 16), 4 << 16);
    line.v_q16 = between(random, -(4 << 16), 4 << 16);
    line.du_q16 = between(random, -30000, 30000);
    line.dv_q16 = between(random, -30000, 30000);
    const int32_t sign = between(random, 0, 1) != 0 ? 1 : -1;
    line.first = 233 * sign;
    line.second = 377 * (between(random, 0, 1) != 0 ? sign : -sign);
    line.base = kPoints / 2;
    return line;
}

void compare(const Field& field)
{
    std::minstd_rand random(3);
    const OverBlack black;
    for (int k = 0; k < kSpans; ++k) {
        CellLine origins = random_line(random);
        CellLine directions = random_line(random);
        LatticeLine checked_origins{origins, {}, false};
        LatticeLine checked_directions{directions, {}, false};
        const int32_t length = between(random, 1, kPixels);
        uint8_t fast[kPixels] = {};
        uint8_t checked[kPixels] = {};
        CellPiece<OverBlack> piece = {field, black, fast, length, origins, directions, nullptr};
        SpanDraw<Nearest>::draw<TexelLuma8, PixelGrey8>(piece);
        SpanDraw<Nearest>::draw_checked<TexelLuma8, PixelGrey8>(
            CheckedPiece<OverBlack>{field, black, checked, length, checked_origins, checked_directions});
        INFO("span " << k);
        REQUIRE(std::memcmp(fast, checked, sizeof(fast)) == 0);
    }
}

}  // namespace

TEST_CASE("one tap through cells is the texel that the checked loop asks for", "[span]")
{
    std::minstd_rand random(1);
    std::vector<uint8_t> texels(kPoints * kStride + kPoints);
    for (uint8_t& t : texels) t = static_cast<uint8_t>(1 + random() % 255);
    Field field;
    field.origins = field.directions = Lattice(kPoints);
    field.used_origins = kPoints;
    field.row_stride_bytes = kStride;
    field.texels = texels.data();
    field.texel_format = TexelFormat::luma8;
    compare(field);
}
