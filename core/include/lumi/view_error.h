// SPDX-License-Identifier: MIT
// A view (view.h) returns these errors: one value for every cause, and its text.
#pragma once
#pragma GCC system_header

#include "lumi/camera.h"
#include "lumi/field.h"

namespace lumi
{

// 1 .. 127 are those of FieldError, 128 .. 159 those of CameraError + 128.
enum class [[nodiscard]] ViewError : uint8_t{
    none = 0,
    other_renderer = 160,  // the field is of another layout or texel format than the build draws
    field_too_large,       // more vertices or patches than the build has memory for
    unaligned_field,       // a chord field whose address is not divisible by 4
    no_field,              // look() or draw() before an open() that succeeded
    no_look,               // draw() before a look() that succeeded
    mode_too_fine,         // the build has less memory for samples than the mode takes
    no_pixels,             // a stripe without memory, or without width or height
    unaligned_pixels,      // an odd address or stride of 16-bit pixels, or one not divisible by 4 of 32-bit ones
    short_stride,          // rows of a stripe overlap
    stripe_too_far,        // the stripe ends beyond what 32 bits count
    stripe_too_large,      // more of the image in one stripe than the build has memory for
    memory_too_small,      // C only: less than lumi_memory_size tells
    unaligned_memory,      // C only: an address that is not divisible by 8
    bad_argument,          // a null pointer, or a number that is out of range
    wrong_span,            // a chord field's mode that is not 2, 4, 8 or 16
};

// Returns one short English phrase that says what to do. Linked only if called.
const char* error_text(ViewError error);

}  // namespace lumi

namespace lumi::detail
{

constexpr ViewError view_error(FieldError error)
{
    // Files of the other layout are whole, but nothing in this build draws them.
    const bool is_other = error == FieldError::chord_field || error == FieldError::surface_field;
    return is_other ? ViewError::other_renderer : static_cast<ViewError>(error);
}

constexpr ViewError view_error(CameraError error)
{
    return error == CameraError::none ? ViewError::none : static_cast<ViewError>(128 + static_cast<uint8_t>(error));
}

}  // namespace lumi::detail
