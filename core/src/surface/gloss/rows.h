// SPDX-License-Identifier: MIT
// The loops of lumi/surface/detail/gloss.h. There is a file for each kind of samples (row_loops.h says why).
#pragma once

#include "lumi/surface/detail/gloss.h"
#include "surface/row_loops.h"

namespace lumi::detail
{

// Adds the disc's colour to a sample that is within its channels.
class AddedGloss
{
public:
    explicit AddedGloss(GlossRows& rows) : rows_(rows) {}

    class Row
    {
    public:
        Row(const GlossRows& rows, uint32_t place) : at_(rows), place_(place - kToMiddle) {}

        PackedColour over(PackedColour colour) const
        {
            LUMI_TALLY(Work::gloss_shown, 1);
            const uint32_t across = (place_ >> 6) & 15, down = (place_ >> 22) & 15;  // 1/16 texel
            const uint8_t* const t = at_.disc + (place_ >> 26) * kGlossDiscSide + ((place_ << 16) >> 26);
            const uint32_t upper = t[0] * (16 - across) + t[1] * across;
            const uint32_t lower = t[kGlossDiscSide] * (16 - across) + t[kGlossDiscSide + 1] * across;
            return saturated_sum(colour, at_.colours[(upper * (16 - down) + lower * down + 128) >> 8]);
        }
        void go_right() { place_ += at_.right; }

    private:
        static constexpr uint32_t kToMiddle = 1u << 25 | 1u << 9;  // half a texel: from its corner to its middle

        const GlossRows at_;
        uint32_t place_;  // from the middle of the upper left of the four texels around it
    };
    Row row_at(uint32_t column) const { return {rows_, rows_.place + column * rows_.right}; }
    void go_down() { rows_.place += rows_.down; }

private:
    GlossRows& rows_;
};

}  // namespace lumi::detail
