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
        Row(const GlossRows& rows, uint32_t place) : at_(rows), place_(place) {}

        PackedColour over(PackedColour colour) const
        {
            LUMI_TALLY(Work::gloss_shown, 1);
            return saturated_sum(colour,
                                 at_.colours[at_.disc[(place_ >> 26) * kGlossDiscSide + ((place_ << 16) >> 26)]]);
        }
        void go_right() { place_ += at_.right; }

    private:
        const GlossRows at_;
        uint32_t place_;
    };
    Row row_at(uint32_t column) const { return {rows_, rows_.place + column * rows_.right}; }
    void go_down() { rows_.place += rows_.down; }

private:
    GlossRows& rows_;
};

}  // namespace lumi::detail
