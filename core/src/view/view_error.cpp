// SPDX-License-Identifier: MIT
#include "lumi/view_error.h"

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
            return "the field has see-through parts (section SSEE): build with the header that `lumi embed` wrote";
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
