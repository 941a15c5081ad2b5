// SPDX-License-Identifier: MIT
// Pieces that a stripe's sides cut: they are drawn into a scanline beside the stripe, of which the stripe gets its
// part. So a rectangle of any columns shows what the whole frame shows there, and loops know nothing of it.
#pragma once

#include "lumi/chord/detail/stepper.h"

namespace lumi::detail
{

inline constexpr int32_t kMostPiecePixels = 1 << kMaxSpanLog2;

inline bool is_cut(const Stripe& stripe, const Piece& piece)
{
    return piece.x < stripe.x_px || piece.x + piece.width > stripe.right_px();
}

// Copies what the stripe holds of a cut piece into `scanline`, where the piece begins.
void copy_from_stripe(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes, uint8_t* scanline);
// And back, after it was drawn.
void copy_into_stripe(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes, const uint8_t* scanline);

}  // namespace lumi::detail
