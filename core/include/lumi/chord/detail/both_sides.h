// SPDX-License-Identifier: MIT
// Both sides of a span through the lattice's cells at once: a side in each half of a word, the origins in the upper
// one, the directions in the lower one.
//
// Coordinates count cells from the one in which the span or tile begins, Q12, in 16 bits: a span's pixels may be up to
// 0.46 cells apart, and its 15 steps reach less than eight cells. Steps are rounded to Q12, which moves a span's last
// pixel by at most 0.002 cells, a tile's by 0.003: 1.1 and 1.9 indices at 65,536 points. No corner leaves the lattice:
// ZoneMap keeps one index and more to spare, TileWalker five.
// Two halves are added as one word: a lower half below zero takes 2^-12 cells from the upper one, on every core.
#pragma once

#include "lumi/chord/detail/both_sides_steps.h"
#include "lumi/chord/detail/piece.h"
#include "lumi/chord/detail/sums.h"

namespace lumi::detail
{

// Rows of three origins, the same three texels of each, weights as Sum takes them.
struct PixelTaps {
    const uint8_t* row[3];
    int32_t offset[2];  // where the second and third texel are
    uint32_t row_weight[3], weight[3];
};

template <class Sum>
LUMI_ALWAYS_INLINE Sum sum_of(const Field& field, const PixelTaps& taps)
{
    Sum sum;
#pragma GCC unroll 3
    for (int m = 0; m < 3; ++m) {
        const uint8_t* row = settled(taps.row[m]);
        typename Sum::Row of_row;
        of_row.add(field, row, taps.weight[0]);
        of_row.add(field, row + taps.offset[0], taps.weight[1]);
        of_row.add(field, row + taps.offset[1], taps.weight[2]);
        sum.add(of_row, taps.row_weight[m]);
    }
    return sum;
}

// Whether a side's cell is divided by the difference of its steps.
struct SideFlip {
    DoubleWord<int32_t> border_and_mask;
    LUMI_ALWAYS_INLINE bool is_flipped(int32_t offset) const
    {
        const DoubleWord<int32_t> flip = reload(border_and_mask);
        return ((offset - flip.a) ^ flip.b) < 0;
    }
};

inline constexpr int32_t kMostSpanPixels = 1 << kMaxSpanLog2;

// Whether a span's steps are few and short enough: from 4095/4096 of a cell 15 of them end within [-8, 8).
inline bool can_follow(const CellLine& origins, const CellLine& directions, int32_t length)
{
    constexpr uint32_t kBelow = 34952;  // steps from -34952/65536 on
    constexpr uint32_t kRange = 0x10000;
    const auto above = [](int32_t d_q16) { return static_cast<uint32_t>(d_q16) + kBelow; };
    return length <= kMostSpanPixels && (above(origins.du_q16) | above(origins.dv_q16) | above(directions.du_q16) |
                                         above(directions.dv_q16)) < kRange;
}

// Coordinates of both sides in the first pixel's cells, and their steps.
inline uint32_t both_sides_begin(int32_t origin_q16, int32_t direction_q16)
{
    const auto fraction = [](int32_t q16) {
        return (static_cast<uint32_t>(q16) >> (16 - kFractionBits)) & ((1u << kFractionBits) - 1);
    };
    return (fraction(origin_q16) << 16) + fraction(direction_q16);
}
inline uint32_t both_sides_step(int32_t origin_q16, int32_t direction_q16)
{
    constexpr int kShift = 16 - kFractionBits;
    const auto rounded = [](int32_t q16) { return static_cast<uint32_t>((q16 + (1 << (kShift - 1))) >> kShift); };
    return (rounded(origin_q16) << 16) + rounded(direction_q16);
}

// Goes over the scanlines of a tile, from its first pixel's cells on, or a single one.
class BothSidesScanlines
{
public:
    template <class Background>
    LUMI_ALWAYS_INLINE BothSidesScanlines(const CellPiece<Background>& span, const TileScanlines* tile)
        : count_(1),
          pixels_(span.pixels),
          at_{both_sides_begin(span.origins.u_q16, span.directions.u_q16),
              both_sides_begin(span.origins.v_q16, span.directions.v_q16)},
          step_{both_sides_step(span.origins.du_q16, span.directions.du_q16),
                both_sides_step(span.origins.dv_q16, span.directions.dv_q16)},
          stride_bytes_(0),  // nothing of what follows is used for one scanline
          step_q16_(step_),
          down_(step_),
          step_down_q16_(step_)
    {
        if (tile != nullptr) begin(span.origins, span.directions, *tile);
    }

    // Whether all scanlines of a tile can be followed: its corners lie less than seven cells from the first pixel, and
    // steps fit into halves, Q16.
    static bool can_follow(const CellLine& side, const LineChange& down, int32_t length)
    {
        return can_follow(side.du_q16, down.u_q16, down.du_q16, length) &&
               can_follow(side.dv_q16, down.v_q16, down.dv_q16, length);
    }

    // Goes on to the next scanline; false below the last one.
    LUMI_ALWAYS_INLINE bool go_down()
    {
        if (--count_ <= 0) return false;
        pixels_ += stride_bytes_;
        move_down(1);
        return true;
    }

    uint8_t* pixels() const { return pixels_; }
    // u and v at the first pixel, and a pixel's steps.
    const DoubleWord<uint32_t>& at() const { return at_; }
    const DoubleWord<uint32_t>& step() const { return step_; }

private:
    static constexpr int32_t kRounding = 1 << (16 - kFractionBits - 1);

    static bool can_follow(int32_t step_q16, int32_t down_q16, int32_t step_down_q16, int32_t length)
    {
        const auto is_near = [](int32_t v_q16) {
            constexpr uint32_t kMost = (7 << 16) - 256;  // steps are rounded
            return static_cast<uint32_t>(v_q16) + kMost < 2 * kMost;
        };
        // With the rounding more than -2^15, as a lower half below zero takes one from the upper one, and below 2^15.
        const auto fits = [](int32_t v_q16) {
            constexpr uint32_t kBelow = 0x7FFFu + kRounding;
            return static_cast<uint32_t>(v_q16) + kBelow < 0xFFFFu;
        };
        const int32_t last_step_q16 = step_q16 + kTileHeight * step_down_q16;
        const int32_t height_q16 = kTileHeight * down_q16;
        return fits(step_q16) && fits(last_step_q16) && is_near(height_q16) && is_near(length * step_q16) &&
               is_near(length * last_step_q16 + height_q16);
    }

    void begin(const CellLine& origins, const CellLine& directions, const TileScanlines& tile)
    {
        const auto both = [](int32_t origin, int32_t direction) {
            return (static_cast<uint32_t>(origin) << 16) + static_cast<uint32_t>(direction);
        };
        const uint32_t rounding = both(kRounding, kRounding);
        count_ = tile.count;
        stride_bytes_ = tile.stride_bytes;
        step_q16_ = {both(origins.du_q16, directions.du_q16) + rounding,
                     both(origins.dv_q16, directions.dv_q16) + rounding};
        down_ = {both_sides_step(tile.origins.u_q16, tile.directions.u_q16),
                 both_sides_step(tile.origins.v_q16, tile.directions.v_q16)};
        step_down_q16_ = {both(tile.origins.du_q16, tile.directions.du_q16),
                          both(tile.origins.dv_q16, tile.directions.dv_q16)};
        if (tile.first > 0) move_down(static_cast<uint32_t>(tile.first));
    }

    // Moves by several scanlines as by one at a time, modulo 2^32.
    LUMI_ALWAYS_INLINE void move_down(uint32_t scanlines)
    {
        at_ = {at_.a + scanlines * down_.a, at_.b + scanlines * down_.b};
        step_q16_ = {step_q16_.a + scanlines * step_down_q16_.a, step_q16_.b + scanlines * step_down_q16_.b};
        step_ = {q12(step_q16_.a), q12(step_q16_.b)};
    }

    // Takes steps to which the rounding is already added.
    static uint32_t q12(uint32_t both_q16)
    {
        constexpr int kShift = 16 - kFractionBits;
        const int32_t high = static_cast<int32_t>(both_q16) >> (16 + kShift);
        const int32_t low = static_cast<int16_t>(both_q16) >> kShift;
        return (static_cast<uint32_t>(high) << 16) + static_cast<uint32_t>(low);
    }

    int32_t count_;
    uint8_t* pixels_;
    DoubleWord<uint32_t> at_, step_;
    uint32_t stride_bytes_;
    DoubleWord<uint32_t> step_q16_, down_, step_down_q16_;
};

// These lead from one origin's texels to the next one's, and from texel to texel.
struct TexelStrides {
    int32_t row_bytes, texel_bytes;
};

// Without kFlips the span has no flipped cells, and nothing is spent on them.
template <bool kFlips>
class BothSidesWalk
{
public:
    BothSidesWalk(const CellLine& origins, const CellLine& directions, const uint8_t* texels,
                  const TexelStrides& strides)
        : steps_(origins, directions, strides.texel_bytes)
    {
        const int32_t origin = steps_.origin_cell(origins.u_q16, origins.v_q16);
        const int32_t direction = steps_.direction_cell(directions.u_q16, directions.v_q16);
        const int32_t first = (origins.base + origin) * strides.row_bytes + directions.base * strides.texel_bytes;
        rows_ = {settled(texels + (first + direction)), strides.row_bytes};
        across_ = {steps_.across_origin() * strides.row_bytes, steps_.across_direction()};
        if (kFlips) {
            origin_flip_ = {{origins.flip - origin, origins.flip_mask}};
            direction_flip_ = {{directions.flip * strides.texel_bytes - direction, directions.flip_mask}};
        }
    }

    LUMI_ALWAYS_INLINE void begin(const BothSidesScanlines& scanlines)
    {
        at_ = scanlines.at();
        step_ = scanlines.step();
    }

    // Finds the next pixel's taps.
    template <class Sum>
    LUMI_ALWAYS_INLINE PixelTaps taps()
    {
        using Bits = BothSidesBits<Sum::kRowBits, Sum::kTapBits>;
        const DoubleWord<uint32_t> at = reload(at_), step = reload(step_);
        at_ = {at.a + step.a, at.b + step.b};
        const uint32_t fu = Bits::fraction(at.a);
        uint32_t fv = Bits::fraction(at.b);
        BothSidesSteps steps = steps_.reloaded();
        int32_t origin = steps.origin(at.a, at.b);
        int32_t direction = steps.direction(at.a, at.b);
        const DoubleWord<const uint8_t*, int32_t> rows = reload(rows_);
        DoubleWord<int32_t> across = reload(across_);
        // A flipped cell is one of the others in the basis of `first` and -`second`: v becomes 1 - v there.
        if (kFlips && __builtin_expect(origin_flip_.is_flipped(origin), false)) {
            origin += steps.second_origin();
            fv += Bits::kOneOrigin - 2 * (fv & 0xFFFF0000u);
            steps.reflect_origins();
            across.a = steps.across_origin() * rows.b;
        }
        if (kFlips && __builtin_expect(direction_flip_.is_flipped(direction), false)) {
            direction += steps.second_direction();
            fv += Bits::kOneDirection - 2 * (fv & 0xFFFFu);
            steps.reflect_directions();
            across.b = steps.across_direction();
        }
        const BothSidesTriangle t = steps.template triangle<Bits>(fu, fv);
        PixelTaps taps;
        taps.row[0] = settled(rows.a + direction) + origin * rows.b;
        taps.row[1] = taps.row[0] + t.middle_origin * rows.b;
        taps.row[2] = taps.row[0] + across.a;
        taps.offset[0] = t.middle_direction;
        taps.offset[1] = across.b;
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) {
            taps.row_weight[k] = Sum::kUpperHalves ? t.weight[k] : t.weight[k] >> 16;
            taps.weight[k] = Sum::kLowerHalves ? t.weight[k] : t.weight[k] & 0xFFFF;
        }
        return taps;
    }

private:
    BothSidesSteps steps_;
    DoubleWord<uint32_t> at_, step_;            // u and v
    DoubleWord<const uint8_t*, int32_t> rows_;  // the texel of the first cells, bytes from one origin to the next
    DoubleWord<int32_t> across_;                // to the corner across, of the origins' rows and within them, in bytes
    SideFlip origin_flip_, direction_flip_;
};

}  // namespace lumi::detail
