// SPDX-License-Identifier: MIT
#include "lumi/chord/detail/piece.h"

namespace lumi::detail
{
namespace
{

// Where the part of a piece lies that the stripe shows.
struct Part {
    uint32_t before, bytes;  // within the piece
    uint8_t* in_stripe;

    Part(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes)
    {
        const int32_t end = piece.x + piece.width, right = stripe.right_px();
        const int32_t from = piece.x > stripe.x_px ? piece.x : stripe.x_px, to = end < right ? end : right;
        before = static_cast<uint32_t>(from - piece.x) * pixel_bytes;
        bytes = static_cast<uint32_t>(to - from) * pixel_bytes;
        in_stripe = stripe.pixels + static_cast<size_t>(piece.y - stripe.y_px) * stripe.stride_bytes +
                    static_cast<uint32_t>(from - stripe.x_px) * pixel_bytes;
    }
};

}  // namespace

void copy_from_stripe(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes, uint8_t* scanline)
{
    const Part part(stripe, piece, pixel_bytes);
    __builtin_memcpy(scanline + part.before, part.in_stripe, part.bytes);
}

void copy_into_stripe(const Stripe& stripe, const Piece& piece, uint32_t pixel_bytes, const uint8_t* scanline)
{
    const Part part(stripe, piece, pixel_bytes);
    __builtin_memcpy(part.in_stripe, scanline + part.before, part.bytes);
}

}  // namespace lumi::detail
