// SPDX-License-Identifier: MIT
// The errors of a view: what finds those of a stripe, and the texts of all.
#include "lumi/view.h"

namespace lumi
{
namespace
{

constexpr uint8_t kCameraErrors = 128, kViewErrors = 160;

const char* describe_field(FieldError error)
{
    switch (error) {
        case FieldError::truncated:
            return "the field is cut off: fewer bytes were given, or flashed, than its header says";
        case FieldError::bad_magic:
            return "no field lies at this address: look at the section in the map file, or flash the field";
        case FieldError::see_through:
            return "the field has see-through parts (section SSEE): build with the header that `lumi embed` wrote, or "
                   "in C with LUMI_C_SEE_THROUGH";
        case FieldError::parts:
            return "the field has moving parts (section SPRT): build with the header that `lumi embed` wrote, or in C "
                   "with LUMI_C_PARTS";
        case FieldError::gloss:
            return "the field has gloss maps (section SGLO): build with the header that `lumi embed` wrote, or in C "
                   "with LUMI_C_GLOSS";
        default:
            return describe(error);
    }
}

}  // namespace

const char* error_text(ViewError error)
{
    const uint8_t code = static_cast<uint8_t>(error);
    if (code < kCameraErrors) return describe_field(static_cast<FieldError>(code));
    if (code < kViewErrors) return describe(static_cast<CameraError>(code - kCameraErrors));
    switch (error) {
        case ViewError::other_renderer:
            return "the field is not of the kind that this build draws: build with the header that `lumi embed` wrote";
        case ViewError::field_too_large:
            return "the field has more vertices or patches than this build has memory for: build with its header";
        case ViewError::unaligned_field:
            return "a chord field's address must be divisible by 4";
        case ViewError::no_field:
            return "no field is open";
        case ViewError::no_look:
            return "nothing was looked at";
        case ViewError::mode_too_fine:
            return "the mode takes more memory for samples than this build has: name it as the finest";
        case ViewError::no_pixels:
            return "the stripe has no memory, width or height";
        case ViewError::unaligned_pixels:
            return "the stripe's address or stride is not a multiple of a pixel's size";
        case ViewError::short_stride:
            return "the stripe's stride is shorter than a row";
        case ViewError::stripe_too_far:
            return "the stripe's place and size are beyond 2147483647 pixels";
        case ViewError::stripe_too_large:
            return "the stripe shows more of the image than this build has memory for: draw fewer rows";
        case ViewError::memory_too_small:
            return "the memory is smaller than lumi_memory_size tells";
        case ViewError::unaligned_memory:
            return "the memory's address must be divisible by 8";
        case ViewError::bad_argument:
            return "an argument is a null pointer or out of range";
        case ViewError::wrong_span:
            return "a chord field's mode is the length of its spans: it must be 2, 4, 8 or 16";
        default:
            return "unknown error";
    }
}

}  // namespace lumi

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

ViewError check_stripe(const Stripe& stripe, const PixelSize& image, uint32_t pixel_bytes, PixelSize& out)
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
