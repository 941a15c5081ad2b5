// SPDX-License-Identifier: MIT
#include "lumi/view.h"

namespace lumi::detail
{
namespace
{

// How many of the numbers [begin, end) lie in [0, size).
int32_t overlap(int32_t begin, int32_t end, int32_t size)
{
    const int32_t from = begin > 0 ? begin : 0, to = end < size ? end : size;
    return to > from ? to - from : 0;
}

// Pixels of 2 or 4 bytes are stored in one access.
uint32_t alignment_of(uint32_t pixel_bytes)
{
    return pixel_bytes == 2 || pixel_bytes == 4 ? pixel_bytes : 1;
}

}  // namespace

ViewError check_stripe(const Stripe& stripe, const ImageSize& image, uint32_t pixel_bytes, StripePart& out)
{
    if (stripe.pixels == nullptr || stripe.width_px <= 0 || stripe.height_px <= 0) return ViewError::no_pixels;
    const uintptr_t mask = alignment_of(pixel_bytes) - 1;
    if (((reinterpret_cast<uintptr_t>(stripe.pixels) | stripe.stride_bytes) & mask) != 0)
        return ViewError::unaligned_pixels;
    const uint64_t row_bytes = static_cast<uint64_t>(stripe.width_px) * pixel_bytes;
    if (stripe.height_px > 1 && stripe.stride_bytes < row_bytes) return ViewError::short_stride;
    if (stripe.right_px() == INT32_MAX || stripe.bottom_px() == INT32_MAX) return ViewError::stripe_too_far;
    out = {overlap(stripe.x_px, stripe.right_px(), image.width_px),
           overlap(stripe.y_px, stripe.bottom_px(), image.height_px)};
    return ViewError::none;
}

}  // namespace lumi::detail
