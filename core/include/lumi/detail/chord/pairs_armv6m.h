// SPDX-License-Identifier: MIT
// draw_pairs' pixels in Armv6-M code, which has eight registers at hand: compilers spill most of what nine taps need.
// The same bits as PairSource and SpanSum.
//
// A coordinate is kept as its fraction at the top of a word, so that an addition's carry tells a new cell and the
// cell's offset moves by additions alone. Of an origin's word, what lies below its 12 bits is the direction's
// coordinate, of which it takes carries as PairSource's halves do; it cannot change how a triangle is chosen but where
// both choices weigh the same corners.
#pragma once

#include "lumi/detail/chord/pairs.h"
#include "lumi/detail/chord/sums.h"

namespace lumi
{

// Whether a sum has an assembled loop.
template <class Sum>
inline constexpr bool kHasThumbPairs = false;
template <bool kFlips, class Sum>
class ThumbPairs;

// Only where all registers may be used: GCC leaves r8 and up alone when it optimises for size, Clang r7 always.
#if defined(__ARM_ARCH_6M__) && defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && !defined(__clang__) && \
    !defined(LUMI_KEEP_FRAME_POINTER)
#define LUMI_HAS_THUMB_PAIRS

// What the code below loads and stores in this order. Offsets and steps are in bytes.
struct ThumbCell {
    uint32_t* moving;        // the address of u
    uint32_t du, dv, drift;  // a pixel's steps; what the offset moves where neither addition carries
    uint32_t u, v, offset;   // of the pixel before; the offset of the cell
};
template <bool kFlips>
struct ThumbOrigins {
    ThumbCell cell;  // its offset is an address
    uint32_t across, first, second, one;
};
template <>
struct ThumbOrigins<true> {
    ThumbCell cell;  // its offset counts from the border of flipped cells, below 2^31 for fields of less than 1 GB
    uint32_t across, first, second, mask, base, one;
};
struct ThumbDirections {
    ThumbCell cell;  // with flips its offset counts from the border
    uint32_t mask_or_one, across, first, second;
};
template <bool kFlips>
struct ThumbState {
    const uint8_t* palette;
    ThumbOrigins<kFlips> origins;
    ThumbDirections directions;
    uint32_t pushed[8];  // not used: as much as the code pushes, which compilers' figures of stacks leave out
};

// ThumbSum<Sum>::of(state) moves on to the next pixel and returns its sum (span_sum_thumb.h).
template <class Sum>
struct ThumbSum;

// clang-format off
#define LUMI_THUMB(...) #__VA_ARGS__ "\n\t"

// Moves a side to its next pixel: r4 u, r5 v, `t` the offset; r0 passes them. `at_first`, `at_second`: where the steps
// are, from u on.
#define LUMI_THUMB_ADVANCE(t, at_first, at_second)    \
    LUMI_THUMB(ldmia r0, {r0, r1, r2, r3, r4, r5, t}) \
    LUMI_THUMB(adds t, t, r3)                         \
    LUMI_THUMB(adds r4, r4, r1)                       \
    LUMI_THUMB(bcc 1f)                                \
    LUMI_THUMB(ldr r3, [r0, at_first])                \
    LUMI_THUMB(adds t, t, r3)                         \
    LUMI_THUMB(1: adds r5, r5, r2)                    \
    LUMI_THUMB(bcc 1f)                                \
    LUMI_THUMB(ldr r3, [r0, at_second])               \
    LUMI_THUMB(adds t, t, r3)                         \
    LUMI_THUMB(1: stmia r0!, {r4, r5, t})

// The triangle of the cell: from r2, r3 (first and second step), r4 and r5 to r2, the middle corner's step, r3 and r5,
// the larger and the smaller fraction of 32 - `shift` bits.
#define LUMI_THUMB_TRIANGLE(shift)    \
    LUMI_THUMB(cmp r4, r5)            \
    LUMI_THUMB(bcs 1f)                \
    LUMI_THUMB(movs r2, r3)           \
    LUMI_THUMB(lsrs r3, r5, shift)    \
    LUMI_THUMB(lsrs r5, r4, shift)    \
    LUMI_THUMB(b 2f)                  \
    LUMI_THUMB(1: lsrs r3, r4, shift) \
    LUMI_THUMB(lsrs r5, r5, shift)    \
    LUMI_THUMB(2:)

// The same, or of a flipped cell where `t` and the mask in `other` say so: that is another one of `first` and
// -`second`. r1 is the step to the corner across.
#define LUMI_THUMB_TRIANGLE_OR_FLIPPED(t, other, shift, bits) \
    LUMI_THUMB(eors other, t)                                 \
    LUMI_THUMB(bpl 3f)                                        \
    LUMI_THUMB(adds t, t, r3)                                 \
    LUMI_THUMB(negs r3, r3)                                   \
    LUMI_THUMB(adds r1, r2, r3)                               \
    LUMI_THUMB(lsrs r4, r4, shift)                            \
    LUMI_THUMB(lsrs r5, r5, shift)                            \
    LUMI_THUMB(movs other, 1)                                 \
    LUMI_THUMB(lsls other, other, bits)                       \
    LUMI_THUMB(subs r5, other, r5)                            \
    LUMI_THUMB(cmp r4, r5)                                    \
    LUMI_THUMB(bcs 1f)                                        \
    LUMI_THUMB(movs r2, r3)                                   \
    LUMI_THUMB(movs r3, r5)                                   \
    LUMI_THUMB(movs r5, r4)                                   \
    LUMI_THUMB(b 2f)                                          \
    LUMI_THUMB(1: movs r3, r4)                                \
    LUMI_THUMB(b 2f)                                          \
    LUMI_THUMB(3:)                                            \
    LUMI_THUMB_TRIANGLE(shift)

// From r0, the state, to nine taps: r6 is the first one's address, r2 and r1 the offsets of a row's second and third
// texel, r4, r3 and r5 their weights; pushed are the first row's weight, the step to the second row, its weight, and so
// on. r0 and r7 are free.
#define LUMI_THUMB_TAPS                     \
    LUMI_THUMB_ADVANCE(r7, 16, 20)          \
    LUMI_THUMB(ldmia r0!, {r1, r2, r3, r6}) \
    LUMI_THUMB_TRIANGLE(%[row_shift])       \
    LUMI_THUMB(subs r4, r1, r2)             \
    LUMI_THUMB(subs r1, r6, r3)             \
    LUMI_THUMB(subs r3, r3, r5)             \
    LUMI_THUMB(push {r1, r2, r3, r4, r5})   \
    LUMI_THUMB_ADVANCE(r6, 20, 24)          \
    LUMI_THUMB(ldmia r0, {r0, r1, r2, r3})  \
    LUMI_THUMB_TRIANGLE(%[tap_shift])       \
    LUMI_THUMB(subs r4, r0, r3)             \
    LUMI_THUMB(subs r3, r3, r5)             \
    LUMI_THUMB(adds r6, r6, r7)

#define LUMI_THUMB_TAPS_OR_FLIPPED                                    \
    LUMI_THUMB_ADVANCE(r7, 16, 20)                                    \
    LUMI_THUMB(ldmia r0!, {r1, r2, r3, r6})                           \
    LUMI_THUMB_TRIANGLE_OR_FLIPPED(r7, r6, %[row_shift], %[row_bits]) \
    LUMI_THUMB(ldmia r0!, {r4, r6})                                   \
    LUMI_THUMB(adds r7, r7, r4)                                       \
    LUMI_THUMB(subs r4, r1, r2)                                       \
    LUMI_THUMB(subs r1, r6, r3)                                       \
    LUMI_THUMB(subs r3, r3, r5)                                       \
    LUMI_THUMB(push {r1, r2, r3, r4, r5})                             \
    LUMI_THUMB_ADVANCE(r6, 20, 24)                                    \
    LUMI_THUMB(ldmia r0, {r0, r1, r2, r3})                            \
    LUMI_THUMB_TRIANGLE_OR_FLIPPED(r6, r0, %[tap_shift], %[tap_bits]) \
    LUMI_THUMB(movs r0, 1)                                            \
    LUMI_THUMB(lsls r0, r0, %[tap_bits])                              \
    LUMI_THUMB(subs r4, r0, r3)                                       \
    LUMI_THUMB(subs r3, r3, r5)                                       \
    LUMI_THUMB(adds r6, r6, r7)
// clang-format on

// What PairSource, its taps and Sum make of a pixel, one pixel after the other.
template <bool kFlips, class Sum>
class ThumbPairs
{
public:
    ThumbPairs(const CellLine& origins, const CellLine& directions, const Field& field, int32_t texel_bytes)
    {
        const uint32_t stride = field.row_stride_bytes;
        const uint32_t bytes = static_cast<uint32_t>(texel_bytes);
        ThumbOrigins<kFlips>& rows = state_.origins;
        ThumbDirections& taps = state_.directions;
        state_.palette = field.palette;
        rows.one = 1u << Sum::kRowBits;
        rows.cell.moving = &rows.cell.u;
        taps.cell.moving = &taps.cell.u;
        rows.first = static_cast<uint32_t>(origins.first) * stride;
        taps.first = static_cast<uint32_t>(directions.first) * bytes;
        rows.second = static_cast<uint32_t>(origins.second) * stride;
        taps.second = static_cast<uint32_t>(directions.second) * bytes;
        rows.across = rows.first + rows.second;
        taps.across = taps.first + taps.second;
        row_offset_ = rows.first * whole(origins.u_q16) + rows.second * whole(origins.v_q16);
        tap_offset_ = taps.first * whole(directions.u_q16) + taps.second * whole(directions.v_q16);
        const uint32_t row = static_cast<uint32_t>(origins.base + (kFlips ? origins.flip : 0)) * stride;
        const uint32_t tap = static_cast<uint32_t>(directions.base + (kFlips ? directions.flip : 0)) * bytes;
        const uint32_t base = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(field.texels)) + row + tap;
        if constexpr (kFlips) {
            rows.mask = static_cast<uint32_t>(origins.flip_mask);
            rows.base = base;
            row_offset_ -= static_cast<uint32_t>(origins.flip) * stride;
            taps.mask_or_one = static_cast<uint32_t>(directions.flip_mask);
            tap_offset_ -= static_cast<uint32_t>(directions.flip) * bytes;
        } else {
            row_offset_ += base;
            taps.mask_or_one = 1u << Sum::kTapBits;
        }
    }

    void begin(const PairRows& pairs)
    {
        ThumbOrigins<kFlips>& rows = state_.origins;
        ThumbDirections& taps = state_.directions;
        rows.cell.offset = row_offset_;
        taps.cell.offset = tap_offset_;
        rows.cell.drift = 0;
        taps.cell.drift = 0;
        in_order();
        begin(Axis{rows.cell.du, taps.cell.du, rows.cell.u, taps.cell.u, rows.first, taps.first}, pairs.at().a,
              pairs.step().a);
        in_order();
        begin(Axis{rows.cell.dv, taps.cell.dv, rows.cell.v, taps.cell.v, rows.second, taps.second}, pairs.at().b,
              pairs.step().b);
    }

    // The next pixel's sum.
    LUMI_ALWAYS_INLINE Sum pixel() { return ThumbSum<Sum>::template of<kFlips>(state_); }

private:
    // Along u or v: where its words are, and the cells' steps.
    struct Axis {
        uint32_t &row_step, &tap_step, &row, &tap;
        uint32_t row_bytes, tap_bytes;
    };
    // What comes before is done before: fewer values in flight.
    LUMI_ALWAYS_INLINE static void in_order() { asm volatile("" ::: "memory"); }

    static uint32_t whole(uint32_t q28) { return static_cast<uint32_t>(static_cast<int32_t>(q28) >> 28); }
    static uint32_t whole(int32_t q16) { return static_cast<uint32_t>(q16 >> 16); }

    LUMI_ALWAYS_INLINE void begin(const Axis& axis, uint32_t at, uint32_t step)
    {
        axis.row_step = step << 4;
        axis.tap_step = step << 20;
        state_.origins.cell.drift += axis.row_bytes * whole(step);
        state_.directions.cell.drift += axis.tap_bytes * whole(step << 16);
        const uint32_t before = at - step;
        axis.row = before << 4;
        axis.tap = before << 20;
        state_.origins.cell.offset += axis.row_bytes * whole(before);
        state_.directions.cell.offset += axis.tap_bytes * whole(before << 16);
    }

    ThumbState<kFlips> state_;
    uint32_t row_offset_, tap_offset_;  // of the first cells
};

#endif

}  // namespace lumi
