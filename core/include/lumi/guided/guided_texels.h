// SPDX-License-Identifier: MIT
// Texels of charts: taps of a grid place, the texels under them, and their weighted sum.
//
// Every number that a file gives is checked where it addresses a texel: whatever the rows hold, reads stay inside.
// Rows and palettes are read in one access each: the field lies at an address divisible by 4.
#pragma once

#include "lumi/detail/chord/sums.h"
#include "lumi/detail/register_hints.h"
#include "lumi/guided/guided_origin.h"

namespace lumi
{

// Sum of weighted colours and of weights, two in a word; weights sum to 2^8 at most.
struct GuidedSum {
    uint32_t rb = 0;  // blue above red
    uint32_t wg = 0;  // Σw above green

    uint32_t weight_q8() const { return wg >> 16; }
    int32_t r_q8() const { return static_cast<int32_t>(rb & 0xFFFFu); }
    int32_t g_q8() const { return static_cast<int32_t>(wg & 0xFFFFu); }
    int32_t b_q8() const { return static_cast<int32_t>(rb >> 16); }
};

// Texel formats: add(texels, chart, number, weight, sum); number is below the table's texel_count. add_pair adds texels
// `number` and the one after it. kDifferences: the colours are differences and enter the sum with 128 more each.
struct GuidedIndex4 {
    static constexpr format::GuidedTexel kFormat = format::GuidedTexel::index4;

    template <bool kDifferences>
    LUMI_ALWAYS_INLINE static void add(const uint8_t* texels, const OriginChart& chart, uint32_t number,
                                       uint32_t weight_q8, GuidedSum& sum)
    {
        const uint32_t pair = texels[number >> 1];
        add_colour(chart, (number & 1) != 0 ? pair >> 4 : pair & 15u, weight_q8, sum);
    }

    template <bool kDifferences>
    LUMI_ALWAYS_INLINE static void add_pair(const uint8_t* texels, const OriginChart& chart, uint32_t number,
                                            uint32_t weight_q8, uint32_t next_weight_q8, GuidedSum& sum)
    {
        const uint8_t* const at = texels + (number >> 1);
        const bool in_two = (number & 1) != 0;
        const uint32_t nibbles = in_two ? at[0] >> 4 | static_cast<uint32_t>(at[1]) << 4 : at[0];
        add_colour(chart, nibbles & 15u, weight_q8, sum);
        add_colour(chart, nibbles >> 4 & 15u, next_weight_q8, sum);
    }

private:
    LUMI_ALWAYS_INLINE static void add_colour(const OriginChart& chart, uint32_t index, uint32_t weight_q8,
                                              GuidedSum& sum)
    {
        const PackedColour& colour = chart.packed.colour[index];
        sum.rb += colour.rb * weight_q8;
        sum.wg += colour.wg * weight_q8;
    }
};

// Adds a colour as it is stored.
template <bool kDifferences>
LUMI_ALWAYS_INLINE void add_entry(const OriginChart& chart, uint32_t number, uint32_t weight_q8, GuidedSum& sum)
{
    const uint32_t stored = load_aligned<uint32_t>(chart.colours + format::kChartColourBytes * number);
    const uint32_t rgb = kDifferences ? stored ^ 0x00808080u : stored;
    sum.rb += (rgb & 0x00FF00FFu) * weight_q8;
    sum.wg += ((rgb >> 8 & 0xFFu) | 0x10000u) * weight_q8;
}

struct GuidedIndex8 {
    static constexpr format::GuidedTexel kFormat = format::GuidedTexel::index8;

    template <bool kDifferences>
    LUMI_ALWAYS_INLINE static void add(const uint8_t* texels, const OriginChart& chart, uint32_t number,
                                       uint32_t weight_q8, GuidedSum& sum)
    {
        const uint32_t index = texels[number];
        if (index == 0) return;
        add_entry<kDifferences>(chart, index, weight_q8, sum);
    }

    template <bool kDifferences>
    LUMI_ALWAYS_INLINE static void add_pair(const uint8_t* texels, const OriginChart& chart, uint32_t number,
                                            uint32_t weight_q8, uint32_t next_weight_q8, GuidedSum& sum)
    {
        add<kDifferences>(texels, chart, number, weight_q8, sum);
        add<kDifferences>(texels, chart, number + 1, next_weight_q8, sum);
    }
};

// No chart: the mean colours alone.
struct NoChart {
    static constexpr format::GuidedTexel kFormat = format::GuidedTexel::none;
};

LUMI_ALWAYS_INLINE uint32_t row_entry(const ChartRows& rows, uint32_t row)
{
    return load_aligned<uint16_t>(rows.rows + 2 * row);
}

// Where a row's entry puts grid column u, from texel_base on.
LUMI_ALWAYS_INLINE uint32_t texel_offset(uint32_t entry, int32_t u)
{
    return (entry + static_cast<uint32_t>(u)) & 0xFFFFu;
}

// Reads texels of charts into sums.
template <class Texel, bool kDifferences>
class ChartReader
{
public:
    static constexpr int kBlockShift = 0;  // rows and numbers are those of grid points

    explicit ChartReader(const GuidedField& field) : texels_(field.chart.texels) {}

    // The texel at an offset below texel_span.
    LUMI_ALWAYS_INLINE void add_at(const OriginChart& chart, uint32_t offset, uint32_t weight_q8, GuidedSum& sum) const
    {
        Texel::template add<kDifferences>(texels_, chart, chart.texels.texel_base + offset, weight_q8, sum);
    }

    // The texels at an offset and the next, both below texel_span.
    LUMI_ALWAYS_INLINE void add_pair_at(const OriginChart& chart, uint32_t offset, uint32_t weight_q8,
                                        uint32_t next_weight_q8, GuidedSum& sum) const
    {
        Texel::template add_pair<kDifferences>(texels_, chart, chart.texels.texel_base + offset, weight_q8,
                                               next_weight_q8, sum);
    }

    // Grid point (u, v), if it has a texel.
    LUMI_ALWAYS_INLINE void add(const OriginChart& chart, int32_t u, int32_t v, uint32_t weight_q8,
                                GuidedSum& sum) const
    {
        const uint32_t row = static_cast<uint32_t>(v - chart.texels.first_row);
        if (row >= chart.texels.row_count) return;
        const uint32_t offset = texel_offset(row_entry(chart.texels, row), u);
        if (offset < chart.texels.texel_span) add_at(chart, offset, weight_q8, sum);
    }

private:
    const uint8_t* texels_;
};

// Rows around a place, as offsets of what is stored at (u, v) and below it.
struct RowOffsets {
    uint32_t near, far;
};

// The corners of a grid triangle: (u, v), (u + 1, v) or, of the upper one, (u, v + 1), and (u + 1, v + 1).
struct TriangleWeights {
    uint32_t upper;  // 1 or 0
    uint32_t first_q8, middle_q8, far_q8;
};

// Which grid points a place reads: policies with add(reader, chart, u, v, weight, sum). Places are absolute, Q8.
//
// Linear: the corners of the grid triangle. Their weights share the origin's without rest, so that Σw stays <= 2^8.
struct LinearTaps {
    static constexpr bool kSingle = false;

    // False, with nothing added, next to the first and last rows and texels: add_at_border()'s.
    template <class Reader>
    LUMI_ALWAYS_INLINE static bool add(const Reader& reader, const OriginChart& chart, int32_t u_q8, int32_t v_q8,
                                       uint32_t weight_q8, GuidedSum& sum)
    {
        const ChartRows& rows = chart.texels;
        constexpr int kShift = 8 + Reader::kBlockShift;
        const uint32_t row = static_cast<uint32_t>((v_q8 >> kShift) - rows.first_row);
        if (row >= rows.last_row) return false;
        const uint32_t near = texel_offset(row_entry(rows, row), u_q8 >> kShift);
        const uint32_t far = texel_offset(row_entry(rows, row + 1), u_q8 >> kShift);
        if ((near | far) + 1 >= rows.texel_span) return false;
        if constexpr (Reader::kBlockShift == 0)
            add_inside(reader, chart, {near, far}, u_q8, v_q8, weight_q8, sum);
        else
            reader.add_triangle(chart, {near, far}, u_q8 >> 8, v_q8 >> 8, weights_of(u_q8, v_q8, weight_q8), sum);
        return true;
    }

    // Every tap on its own.
    template <class Reader>
    LUMI_ALWAYS_INLINE static void add_at_border(const Reader& reader, const OriginChart& chart, int32_t u_q8,
                                                 int32_t v_q8, uint32_t weight_q8, GuidedSum& sum)
    {
        const int32_t u = u_q8 >> 8, v = v_q8 >> 8;
        const TriangleWeights weights = weights_of(u_q8, v_q8, weight_q8);
        const int32_t upper = static_cast<int32_t>(weights.upper);
        reader.add(chart, u, v, weights.first_q8, sum);
        reader.add(chart, u + 1 - upper, v + upper, weights.middle_q8, sum);
        reader.add(chart, u + 1, v + 1, weights.far_q8, sum);
    }

private:
    // A share of the origin's weight, rounded and cut.
    LUMI_ALWAYS_INLINE static uint32_t middle_share(uint32_t weight_q8, int32_t share_q8)
    {
        return (weight_q8 * static_cast<uint32_t>(share_q8) + 128) >> 8;
    }
    LUMI_ALWAYS_INLINE static uint32_t far_share(uint32_t weight_q8, int32_t share_q8)
    {
        return (weight_q8 * static_cast<uint32_t>(share_q8)) >> 8;
    }

    template <class Reader>
    LUMI_ALWAYS_INLINE static void add_inside(const Reader& reader, const OriginChart& chart, const RowOffsets& offset,
                                              int32_t u_q8, int32_t v_q8, uint32_t weight_q8, GuidedSum& sum)
    {
        const int32_t fu = u_q8 & 255, fv = v_q8 & 255;
        if (fu >= fv) {
            const uint32_t middle = middle_share(weight_q8, fu - fv), far = far_share(weight_q8, fv);
            reader.add_at(chart, offset.far + 1, far, sum);
            reader.add_pair_at(chart, offset.near, weight_q8 - middle - far, middle, sum);
        } else {
            const uint32_t middle = middle_share(weight_q8, fv - fu), far = far_share(weight_q8, fu);
            reader.add_at(chart, offset.near, weight_q8 - middle - far, sum);
            reader.add_pair_at(chart, offset.far, middle, far, sum);
        }
    }

    LUMI_ALWAYS_INLINE static TriangleWeights weights_of(int32_t u_q8, int32_t v_q8, uint32_t weight_q8)
    {
        const int32_t fu = u_q8 & 255, fv = v_q8 & 255;
        const bool upper = fu < fv;
        const uint32_t middle = middle_share(weight_q8, upper ? fv - fu : fu - fv);
        const uint32_t far = far_share(weight_q8, upper ? fu : fv);
        return {upper ? 1u : 0u, weight_q8 - middle - far, middle, far};
    }
};

// Nearest: the heaviest corner of the grid triangle.
struct NearestTap {
    static constexpr bool kSingle = true;  // a tap has all of an origin's weight, which can multiply its colour later

    template <class Reader>
    LUMI_ALWAYS_INLINE static void add(const Reader& reader, const OriginChart& chart, int32_t u_q8, int32_t v_q8,
                                       uint32_t weight_q8, GuidedSum& sum)
    {
        // With weights 1 - max, |fu - fv|, min: a corner with u + 1 is the heaviest where 2fu - fv > 1, or where
        // fu + fv > 1 and 2fu > fv; one with v + 1 with fu and fv exchanged. Negative numbers stand for these.
        constexpr int32_t kOne = 256;
        const int32_t fu = u_q8 & 255;
        const int32_t fv = v_q8 & 255;
        const int32_t u_behind = fv - 2 * fu;
        const int32_t v_behind = fu - 2 * fv;
        const int32_t near = kOne - fu - fv;
        const int32_t u = (u_q8 >> 8) - (((kOne + u_behind) | (near & u_behind)) >> 31);
        const int32_t v = (v_q8 >> 8) - (((kOne + v_behind) | (near & v_behind)) >> 31);
        reader.add(chart, u, v, weight_q8, sum);
    }
};

// How far an origin sees in column u and row v of its table: |X - p|² at most.
LUMI_ALWAYS_INLINE uint32_t depth_limit2_q28(const DepthRows& rows, int32_t u, int32_t v)
{
    constexpr uint32_t kHidesNothing = 255;
    const uint32_t row = static_cast<uint32_t>(v - rows.first_row);
    if (row >= rows.row_count) return UINT32_MAX;
    const uint32_t offset = texel_offset(load_aligned<uint16_t>(rows.rows + 2 * row), u);
    if (offset >= rows.depth_span) return UINT32_MAX;
    const uint32_t depth = rows.depths[offset];  // in 1/128
    return depth == kHidesNothing ? UINT32_MAX : depth * depth << 14;
}

// Whether an origin does not see the X at a place of its chart.
LUMI_ALWAYS_INLINE bool is_hidden(const OriginChart& chart, const ChartPlace& place)
{
    constexpr int kBlockShift = 8 + static_cast<int>(format::kOcclusionShift);
    const uint32_t cell = join_halves<kBlockShift>(place.v_q8, place.u_q8);
    if (__builtin_expect(cell != chart.seen.place, false)) {
        const int32_t u = place.u_q8 >> kBlockShift, v = place.v_q8 >> kBlockShift;
        chart.seen = {cell, depth_limit2_q28(chart.occlusion, u, v)};
    }
    return place.distance2_q28 > chart.seen.limit2_q28;
}

}  // namespace lumi
