// SPDX-License-Identifier: MIT
// Spans of 3x3 texels in Armv6-M assembly (core/src/chord/armv6m), whose loops keep in eight registers what compilers
// spill: a loop writes the weighted sums of a scanline's pixels, the same bits as BothSidesWalk and TexelSum have.
//
// A coordinate is kept as its fraction at the top of a word, so that an addition's carry tells a new cell and the
// cell's offset moves by additions alone. The bits of an origin's word below its 12 bits are the direction's
// coordinate: its carries reach the origin as in BothSidesWalk's halves. They cannot change which triangle is chosen,
// except where both choices weigh the same corners.
#pragma once

#include <stddef.h>

#include "lumi/chord/detail/both_sides.h"
#include "lumi/chord/detail/sums.h"

namespace lumi::detail
{

// Whether a sum has an assembled loop, and which: Scanlines of cells, draw(), and the sum of a pixel's kWords words.
template <class Sum>
struct Armv6mLoop {
    static constexpr bool kExists = false;
};

#ifdef __ARM_ARCH_6M__

// One side, in the order in which loops load it. Steps and offsets are in bytes.
struct LinearSide {
    uint32_t* moving;        // the address of u
    uint32_t du, dv, drift;  // a pixel's steps; what the offset moves where neither addition carries
    uint32_t u, v, offset;   // those of the pixel before; the cell's offset
    uint32_t one_or_mask;    // one as a weight; if cells may be flipped, SideFlip's mask
    uint32_t first, second, across;
};

// Where no cell is flipped the origins' offset is an address. Else `base` is the address from which both offsets count,
// each from the border of its flipped cells, below 2^31 for fields of less than 1 GB.
struct LinearCells {
    LinearSide origins, directions;
    uint32_t base, may_flip;
};
static_assert(offsetof(LinearSide, first) - offsetof(LinearSide, u) == 16, "SIDE_FIRST, SIDE_SECOND of taps.inc");
static_assert(offsetof(LinearCells, base) == 88, "CELLS_BASE, CELLS_MAY_FLIP of taps.inc");

// Draw from the pixel after the one at which `cells` are, and move them on, until `sums` reaches `end`: at least one.
extern "C" {
void lumi_linear_luma8(uint32_t* sums, const uint32_t* end, LinearCells* cells);
void lumi_linear_rgb888(uint32_t* sums, const uint32_t* end, LinearCells* cells);
void lumi_linear_rgb565(uint32_t* sums, const uint32_t* end, LinearCells* cells);
void lumi_linear_palette8(uint32_t* sums, const uint32_t* end, LinearCells* cells, const uint8_t* palette);
}

// Holds the cells of a span's or a tile's scanlines.
class LinearScanlines
{
public:
    struct Bits {
        int row, tap;
    };
    LinearScanlines(const CellLine& origins, const CellLine& directions, const Field& field, uint32_t texel_bytes,
                    Bits bits)
    {
        const bool may_flip = !(origins.uniform && directions.uniform);
        const uint32_t row = begin(cells_.origins, origins, field.row_stride_bytes, may_flip ? 0 : 1u << bits.row);
        const uint32_t tap = begin(cells_.directions, directions, texel_bytes, may_flip ? 0 : 1u << bits.tap);
        const uint32_t base = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(field.texels)) + row + tap;
        cells_.base = base;
        cells_.may_flip = may_flip;
        origin_offset_ = cells_.origins.offset + (may_flip ? 0 : base);
        direction_offset_ = cells_.directions.offset;
    }

    // Returns the cells before a scanline's first pixel.
    LinearCells* before(const BothSidesScanlines& scanlines)
    {
        const DoubleWord<uint32_t>& step = scanlines.step();
        const DoubleWord<uint32_t> before = {scanlines.at().a - step.a, scanlines.at().b - step.b};
        begin(cells_.origins, origin_offset_, before, step);
        begin(cells_.directions, direction_offset_, {before.a << 16, before.b << 16}, {step.a << 16, step.b << 16});
        return &cells_;
    }

private:
    // Sets what all scanlines share, and the offset of the first one's cell. Returns the place from which all offsets
    // count. `one` is 0 if cells may be flipped.
    static uint32_t begin(LinearSide& to, const CellLine& side, uint32_t bytes, uint32_t one)
    {
        const auto whole = [](int32_t q16) { return static_cast<uint32_t>(q16 >> 16); };
        const uint32_t border = one == 0 ? static_cast<uint32_t>(side.flip) : 0;
        to.moving = &to.u;
        to.one_or_mask = one == 0 ? static_cast<uint32_t>(side.flip_mask) : one;
        to.first = static_cast<uint32_t>(side.first) * bytes;
        to.second = static_cast<uint32_t>(side.second) * bytes;
        to.across = to.first + to.second;
        to.offset = to.first * whole(side.u_q16) + to.second * whole(side.v_q16) - border * bytes;
        return (static_cast<uint32_t>(side.base) + border) * bytes;
    }

    // Coordinates and steps in the upper halves.
    static void begin(LinearSide& to, uint32_t offset, const DoubleWord<uint32_t>& at, const DoubleWord<uint32_t>& step)
    {
        const auto whole = [](uint32_t q28) { return static_cast<uint32_t>(static_cast<int32_t>(q28) >> 28); };
        to.du = step.a << 4;
        to.dv = step.b << 4;
        to.drift = to.first * whole(step.a) + to.second * whole(step.b);
        to.u = at.a << 4;
        to.v = at.b << 4;
        to.offset = offset + to.first * whole(at.a) + to.second * whole(at.b);
    }

    LinearCells cells_;
    uint32_t origin_offset_, direction_offset_;  // where the first cells are
};

template <uint32_t kSumWords>
struct Armv6mLoopOf {
    static constexpr bool kExists = true;
    static constexpr uint32_t kWords = kSumWords;
    using Scanlines = LinearScanlines;
};

template <>
struct Armv6mLoop<TexelSum<TexelLuma8, false>> : Armv6mLoopOf<1> {
    static void draw(uint32_t* sums, const uint32_t* end, LinearCells* cells, const uint8_t*)
    {
        lumi_linear_luma8(sums, end, cells);
    }
    static TexelSum<TexelLuma8, false> sum(const uint32_t* y) { return {y[0], 0}; }
};

template <>
struct Armv6mLoop<TexelSum<TexelRgb888, false>> : Armv6mLoopOf<3> {
    static void draw(uint32_t* sums, const uint32_t* end, LinearCells* cells, const uint8_t*)
    {
        lumi_linear_rgb888(sums, end, cells);
    }
    static TexelSum<TexelRgb888, false> sum(const uint32_t* rgb) { return {rgb[0], rgb[1], rgb[2], 0}; }
};

template <>
struct Armv6mLoop<TexelSum<TexelRgb565, false>> : Armv6mLoopOf<3> {
    static void draw(uint32_t* sums, const uint32_t* end, LinearCells* cells, const uint8_t*)
    {
        lumi_linear_rgb565(sums, end, cells);
    }
    static TexelSum<TexelRgb565, false> sum(const uint32_t* rgb) { return {rgb[0], rgb[1], rgb[2], 0}; }
};

template <>
struct Armv6mLoop<TexelSum<TexelPalette8, false>> : Armv6mLoopOf<3> {
    static void draw(uint32_t* sums, const uint32_t* end, LinearCells* cells, const uint8_t* palette)
    {
        lumi_linear_palette8(sums, end, cells, palette);
    }
    static TexelSum<TexelPalette8, false> sum(const uint32_t* rgb) { return {rgb[0], rgb[1], rgb[2], 0}; }
};

#endif

}  // namespace lumi::detail
