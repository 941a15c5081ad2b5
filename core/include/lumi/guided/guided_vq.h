// SPDX-License-Identifier: MIT
// Texels in blocks of 2×2 grid points: a byte names one of 255 blocks of four colours that a group of origins shares.
// Two bits a texel: a chart of the same bytes has twice the texels of one with 4 bits.
//
//     using Best = GuidedPolicy<ThreeOrigins, LinearTaps, GuidedVq8, MeanPalette8, OcclusionUse::read>;
#pragma once

#include "lumi/guided/guided_texels.h"

namespace lumi
{

struct GuidedVq8 {
    static constexpr format::GuidedTexel kFormat = format::GuidedTexel::vq8;
};

template <bool kDifferences>
class ChartReader<GuidedVq8, kDifferences>
{
public:
    static constexpr int kBlockShift = 1;  // rows and numbers are those of blocks

    explicit ChartReader(const GuidedField& field) : texels_(field.chart.texels) {}

    // Grid point (u, v), if its block is there.
    LUMI_ALWAYS_INLINE void add(const OriginChart& chart, int32_t u, int32_t v, uint32_t weight_q8,
                                GuidedSum& sum) const
    {
        const ChartRows& rows = chart.texels;
        const uint32_t row = static_cast<uint32_t>((v >> kBlockShift) - rows.first_row);
        if (row >= rows.row_count) return;
        const uint32_t offset = texel_offset(row_entry(rows, row), u >> kBlockShift);
        if (offset >= rows.texel_span) return;
        add_corner(chart, offset, static_cast<uint32_t>(u), static_cast<uint32_t>(v), weight_q8, sum);
    }

    // The corners around (u, v), whose block and the one below it lie at `offset`; these and the next are below
    // texel_span.
    LUMI_ALWAYS_INLINE void add_triangle(const OriginChart& chart, const RowOffsets& offset, int32_t u, int32_t v,
                                         const TriangleWeights& weights, GuidedSum& sum) const
    {
        const uint32_t from_u = static_cast<uint32_t>(u) & 1u, from_v = static_cast<uint32_t>(v) & 1u;
        const auto add = [&](uint32_t du, uint32_t dv, uint32_t weight_q8) {
            const uint32_t in_u = from_u + du, in_v = from_v + dv;  // 0 .. 2 from the first block's corner
            const uint32_t block = (in_v > 1 ? offset.far : offset.near) + (in_u >> 1);
            add_corner(chart, block, in_u, in_v, weight_q8, sum);
        };
        add(0, 0, weights.first_q8);
        add(1 - weights.upper, weights.upper, weights.middle_q8);
        add(1, 1, weights.far_q8);
    }

private:
    // The corner of a block where grid point (u, v) lies; `offset` is below texel_span.
    LUMI_ALWAYS_INLINE void add_corner(const OriginChart& chart, uint32_t offset, uint32_t u, uint32_t v,
                                       uint32_t weight_q8, GuidedSum& sum) const
    {
        const uint32_t block = texels_[chart.texels.texel_base + offset];
        if (block == 0) return;
        add_entry<kDifferences>(chart, 4 * block + 2 * (v & 1u) + (u & 1u), weight_q8, sum);
    }

    const uint8_t* texels_;
};

}  // namespace lumi
