// SPDX-License-Identifier: MIT
// Both sides of a span or a tile in one word against each side by itself.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lumi/background.h"
#include "lumi/chord/detail/both_sides.h"
#include "lumi/chord/detail/side_taps.h"
#include "lumi/chord/detail/tile.h"

using namespace lumi;
using namespace lumi::detail;

namespace
{

#ifdef LUMI_TEST_LIGHT
constexpr int kSpans = 300;
#else
constexpr int kSpans = 30000;
#endif
constexpr int32_t kPixels = 16;
constexpr int32_t kRowBytes = 1 << 16;  // rows and texels can be told from an address
constexpr int32_t kTexelBytes = 3;
constexpr uintptr_t kTexels = 0x40000000;  // nothing is read there

// A sum that asks only for taps.
template <int kBitsOfRow, int kBitsOfTap>
struct Weights {
    static constexpr int kRowBits = kBitsOfRow;
    static constexpr int kTapBits = kBitsOfTap;
    static constexpr bool kUpperHalves = false;
    static constexpr bool kLowerHalves = false;
};

// The mean of values that belong to the corners, the same wherever a corner is met. The triangles of neighbouring cells
// share edges, so that it does not jump.
double mean(const int32_t offset[3], const uint32_t weight[3], int bits)
{
    double sum = 0;
    for (int k = 0; k < 3; ++k)
        sum += weight[k] * static_cast<double>((static_cast<uint32_t>(offset[k]) * 2654435761u) >> 24);
    return sum / (1 << bits);
}

int32_t between(std::minstd_rand& random, int32_t low, int32_t high)
{
    return std::uniform_int_distribution<int32_t>(low, high)(random);
}

CellLine random_side(std::minstd_rand& random, int32_t most_step_q16)
{
    CellLine side{};
    side.u_q16 = between(random, -(4 << 16), 4 << 16);
    side.v_q16 = between(random, -(4 << 16), 4 << 16);
    side.du_q16 = between(random, -most_step_q16, most_step_q16);
    side.dv_q16 = between(random, -most_step_q16, most_step_q16);
    const int32_t sign = between(random, 0, 1) != 0 ? 1 : -1;
    side.first = 233 * (between(random, 0, 1) != 0 ? sign : -sign);
    side.second = 377 * sign;
    // All of one kind: cells of both kinds side by side do not share triangles.
    side.flip = -100000;
    side.flip_mask = -between(random, 0, 1);
    side.uniform = side.flip_mask == 0;
    return side;
}

LineChange random_down(std::minstd_rand& random, int32_t most_q16)
{
    const int32_t most_change = most_q16 / 64;
    return {between(random, -most_q16, most_q16), between(random, -most_q16, most_q16),
            between(random, -most_change, most_change), between(random, -most_change, most_change)};
}

// The largest difference between the values of a scanline's pixels, on either side.
template <int kRowBits, int kTapBits, bool kFlips>
double worst_of_scanline(BothSidesWalk<kFlips>& both, const CellLine& origins, const CellLine& directions)
{
    LatticeLine row_line{origins, {}, false};
    LatticeLine texel_line{directions, {}, false};
    SideWalk rows(row_line);
    SideWalk taps(texel_line);
    double worst = 0;
    for (int32_t k = 0; k < kPixels; ++k) {
        const PixelTaps got = both.template taps<Weights<kRowBits, kTapBits>>();
        int32_t row[3], texel[3];
        for (int m = 0; m < 3; ++m) {
            const int32_t at = static_cast<int32_t>(reinterpret_cast<uintptr_t>(got.row[m]) - kTexels);
            row[m] = (at + kRowBytes / 2) >> 16;
            texel[0] = at - row[m] * kRowBytes;
        }
        texel[1] = texel[0] + got.offset[0];
        texel[2] = texel[0] + got.offset[1];
        const SideTaps of_row = rows.taps<kRowBits>();
        SideTaps of_texel = taps.taps<kTapBits>();
        for (int32_t& index : of_texel.index) index *= kTexelBytes;
        worst = std::max(worst,
                         std::fabs(mean(row, got.row_weight, kRowBits) - mean(of_row.index, of_row.weight, kRowBits)));
        worst = std::max(
            worst, std::fabs(mean(texel, got.weight, kTapBits) - mean(of_texel.index, of_texel.weight, kTapBits)));
        rows.advance();
        taps.advance();
    }
    return worst;
}

// Checks all scanlines of a tile, or a span's one.
template <bool kFlips, int kRowBits, int kTapBits>
double worst_difference(CellLine origins, CellLine directions, const TileScanlines* tile)
{
    const Field field;
    const OverBlack background;
    uint8_t pixels[1];  // not drawn to
    CellPiece<OverBlack> span = {field, background, pixels, kPixels, origins, directions, tile};
    const uint8_t* const texels = reinterpret_cast<const uint8_t*>(kTexels);
    BothSidesWalk<kFlips> both(origins, directions, texels, {kRowBytes, kTexelBytes});
    BothSidesScanlines scanlines(span, tile);
    int32_t left = span.scanlines();
    span.go_to_first();
    double worst = 0;
    for (;;) {
        both.begin(scanlines);
        worst = std::max(worst, worst_of_scanline<kRowBits, kTapBits>(both, origins, directions));
        const bool is_more = scanlines.go_down();
        REQUIRE(span.go_down(left) == is_more);
        if (!is_more) return worst;
    }
}

// Over spans that both ways can follow, the worst pixel. `most_step_q16` may be more than both at once can.
template <int kRowBits, int kTapBits>
double worst_of_spans(int32_t most_step_q16)
{
    std::minstd_rand random(1);
    double worst = 0;
    int followed = 0;
    for (int k = 0; k < kSpans; ++k) {
        const CellLine origins = random_side(random, most_step_q16);
        const CellLine directions = random_side(random, most_step_q16);
        if (!can_follow(origins, directions, kPixels)) continue;
        ++followed;
        worst = std::max(worst, worst_difference<true, kRowBits, kTapBits>(origins, directions, nullptr));
        if (origins.uniform && directions.uniform)
            worst = std::max(worst, worst_difference<false, kRowBits, kTapBits>(origins, directions, nullptr));
    }
    CHECK(followed > kSpans / 20);
    return worst;
}

// Over tiles that both ways can follow, as far as both at once can.
template <int kRowBits, int kTapBits>
double worst_of_tiles(int32_t most_step_q16)
{
    std::minstd_rand random(2);
    double worst = 0;
    int followed = 0;
    for (int k = 0; k < kSpans; ++k) {
        const CellLine origins = random_side(random, most_step_q16);
        const CellLine directions = random_side(random, most_step_q16);
        const LineChange down[] = {random_down(random, 2 * most_step_q16), random_down(random, 2 * most_step_q16)};
        const int32_t first = between(random, 0, kTileHeight - 1);
        const TileScanlines tile = {first, kTileHeight - first, 0, down[0], down[1]};
        if (!BothSidesScanlines::can_follow(origins, down[0], kPixels) ||
            !BothSidesScanlines::can_follow(directions, down[1], kPixels))
            continue;
        ++followed;
        worst = std::max(worst, worst_difference<true, kRowBits, kTapBits>(origins, directions, &tile));
        if (origins.uniform && directions.uniform)
            worst = std::max(worst, worst_difference<false, kRowBits, kTapBits>(origins, directions, &tile));
    }
    CHECK(followed > kSpans / 50);
    return worst;
}

}  // namespace

TEST_CASE("both sides of a span at once have the taps of each by itself", "[span]")
{
    // A coordinate is off by 16 roundings of a step, one of the beginning and one borrowed: 2.5/1024 cells at most.
    // Along each of u and v a value of 255 changes by no more than that a cell.
    const double off = 2 * 255 * 2.5 / 1024;
    CHECK(worst_of_spans<12, 12>(30000) < off + 255 * 3 / 4096.0);
    // Coarser weights round coordinates down: one more step of theirs on either side.
    CHECK(worst_of_spans<7, 7>(30000) < off + 2 * 255 / 128.0);
    CHECK(worst_of_spans<8, 5>(30000) < off + 2 * 255 / 32.0);
}

TEST_CASE("both sides of a tile at once have the taps of each by itself", "[span]")
{
    // Eight roundings of what a scanline changes by are half a cell's 1024th more.
    const double off = 2 * 255 * 4.0 / 1024;
    CHECK(worst_of_tiles<12, 12>(30000) < off + 255 * 3 / 4096.0);
    CHECK(worst_of_tiles<7, 7>(30000) < off + 2 * 255 / 128.0);
    CHECK(worst_of_tiles<8, 5>(30000) < off + 2 * 255 / 32.0);
}

TEST_CASE("tiles too wide for halves of a word are told", "[span]")
{
    const CellLine still{};
    const LineChange level{};
    CHECK(BothSidesScanlines::can_follow(still, level, kPixels));
    static constexpr int32_t kTooFast[] = {28656, -28657, 1 << 20, -(1 << 20), INT32_MAX, INT32_MIN};
    for (int32_t CellLine::*step : {&CellLine::du_q16, &CellLine::dv_q16}) {
        for (const int32_t too_fast : kTooFast) {
            CellLine fast{};
            fast.*step = too_fast;
            CHECK_FALSE(BothSidesScanlines::can_follow(fast, level, kPixels));
        }
    }
    // Half a cell a pixel in the upper half, less one that a lower half below zero takes, would turn round.
    constexpr int32_t kFew = 8;
    CellLine fast{};
    fast.du_q16 = -32775;
    CHECK(BothSidesScanlines::can_follow(fast, level, kFew));
    fast.du_q16 = -32776;
    CHECK_FALSE(BothSidesScanlines::can_follow(fast, level, kFew));
    fast.du_q16 = 32759;
    CHECK(BothSidesScanlines::can_follow(fast, level, kFew));
    fast.du_q16 = 32760;
    CHECK_FALSE(BothSidesScanlines::can_follow(fast, level, kFew));
    for (int32_t LineChange::*down : {&LineChange::u_q16, &LineChange::v_q16}) {
        for (const int32_t too_steep : {57312, -57313, 1 << 26, -(1 << 26)}) {
            LineChange steep{};
            steep.*down = too_steep;
            CHECK_FALSE(BothSidesScanlines::can_follow(still, steep, kPixels));
        }
    }
    for (int32_t LineChange::*down : {&LineChange::du_q16, &LineChange::dv_q16}) {
        for (const int32_t too_bent : {3584, -3584, 1 << 20, -(1 << 20)}) {
            LineChange bent{};
            bent.*down = too_bent;
            CHECK_FALSE(BothSidesScanlines::can_follow(still, bent, kPixels));
        }
    }
}

TEST_CASE("spans too fast for halves of a word are told", "[span]")
{
    CHECK(worst_of_spans<12, 12>(60000) < 2);
    CellLine still{};
    CHECK(can_follow(still, still, kPixels));
    CHECK_FALSE(can_follow(still, still, kPixels + 1));
    static constexpr int32_t kTooFast[] = {30584, -34953, 1 << 20, -(1 << 20), INT32_MAX, INT32_MIN};
    for (int32_t CellLine::*step : {&CellLine::du_q16, &CellLine::dv_q16}) {
        for (const int32_t too_fast : kTooFast) {
            CellLine fast{};
            fast.*step = too_fast;
            CHECK_FALSE(can_follow(fast, still, 2));
            CHECK_FALSE(can_follow(still, fast, 2));
        }
    }
}
