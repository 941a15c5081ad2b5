// SPDX-License-Identifier: MIT
// The see-through triangles of a frame and the loops that blend their rows over what samples hold.
//
// A sample without a surface tells in its depth how much of the background shows: below kShownDepth all of it, and
// nothing was drawn there; from there up to kFarDepth - 1, what is between the two is the share that is covered.
#pragma once

#include "lumi/surface/detail/marks.h"
#include "lumi/surface/detail/pieces.h"
#include "lumi/surface/see_through_frame.h"

namespace lumi::detail
{

// The triangles of that list that reach a target, as TrianglePieces has them.
class SeeThroughPieces
{
public:
    SeeThroughPieces(const SeeThroughFrame& frame, const Target& target) : piece(target), frame_(frame), target_(target)
    {
    }

    // Makes `piece` the next one; false after the last.
    LUMI_HOT bool next();

    TrianglePiece piece;

private:
    const SeeThroughFrame& frame_;
    const Target& target_;
    uint32_t at_ = 0;
    Parts parts_;
};

// Loops over rows whose palette is SeeThroughFrame::added_and_passed.
LUMI_HOT void blend_565_nearest(Rows& rows);
LUMI_HOT void blend_565_two_taps(Rows& rows);
LUMI_HOT void blend_565_bilinear(Rows& rows);
LUMI_HOT void blend_565_swapped_nearest(Rows& rows);
LUMI_HOT void blend_565_swapped_two_taps(Rows& rows);
LUMI_HOT void blend_565_swapped_bilinear(Rows& rows);
LUMI_HOT void blend_packed_nearest(Rows& rows);
LUMI_HOT void blend_packed_two_taps(Rows& rows);
LUMI_HOT void blend_packed_bilinear(Rows& rows);

template <class Pixel>
inline constexpr RowFilters kPixelBlends = {};
template <>
inline constexpr RowFilters kPixelBlends<PixelRgb565> = {blend_565_nearest, blend_565_two_taps, blend_565_bilinear};
template <>
inline constexpr RowFilters kPixelBlends<PixelRgb565Swapped> = {blend_565_swapped_nearest, blend_565_swapped_two_taps,
                                                                blend_565_swapped_bilinear};
inline constexpr RowFilters kPackedBlends = {blend_packed_nearest, blend_packed_two_taps, blend_packed_bilinear};

// As mark_outlines() does, of see-through triangles over a colour that is known beside the target.
LUMI_HOT void mark_see_through_outlines(const SeeThroughFrame& frame, const Target& target);

// Draws see-through triangles over samples.
template <DrawRows kPlain, DrawRows kMagnified = kPlain>
__attribute__((noinline)) void blend_triangles(const SeeThroughFrame& frame, const Target& opaque)
{
    Target target = opaque;
    target.palette = frame.added_and_passed;
    SeeThroughPieces pieces(frame, target);
    draw_pieces<kPlain, kMagnified>(pieces, target);
}

}  // namespace lumi::detail
