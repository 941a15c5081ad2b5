// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/pieces.h"

#include "surface/fill.h"
#include "surface/lists.h"

namespace lumi::detail
{

TrianglePieces::TrianglePieces(const SurfaceFrame& frame, const Target& target)
    : piece(target),
      frame_(frame),
      target_(target),
      walk_(walk_of(frame, target)),
      other_(frame.memory.bands[frame.other_list])
{
}

LUMI_HOT bool TrianglePieces::next()
{
    if (piece.is_wide && next_part_of_wide(piece)) return true;
    for (uint32_t triangle = 0; next_listed(walk_, frame_, triangle);)
        if (begin_whole(piece, frame_, triangle, target_)) return true;
    return next_cut();
}

__attribute__((noinline)) bool TrianglePieces::next_cut()
{
    while (true) {
        if (begin_piece(piece, frame_, cut_, target_)) return true;
        if (other_ == kEmptyBand) return false;
        begin_cut(cut_, frame_, other_);
        other_ = after(other_, frame_.memory.links[other_]);
    }
}

}  // namespace lumi::detail
