// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/target.h"

namespace lumi::detail
{
namespace
{

int32_t within(int32_t v, const Extent& range)
{
    return v < range.begin ? range.begin : v < range.end ? v : range.end;
}

struct __attribute__((may_alias)) EightWords {
    uint32_t word[8];
};

// Stores of several words at once.
LUMI_ALWAYS_INLINE uint32_t* fill_words(uint32_t* at, uint32_t count, uint32_t value)
{
    const EightWords eight = {{value, value, value, value, value, value, value, value}};
    for (; count >= 8; count -= 8, at += 8) *reinterpret_cast<EightWords*>(at) = eight;
    for (; count != 0; --count) *at++ = value;
    return at;
}

uint32_t* first_word(const SampleRows& rows)
{
    return reinterpret_cast<uint32_t*>(reinterpret_cast<uintptr_t>(rows.first) & ~uintptr_t{3});
}

void clear_marks(const SampleRows& rows)
{
    if (rows.marks != nullptr) fill_words(rows.marks, rows.marks_words() * static_cast<uint32_t>(rows.height), 0);
}

}  // namespace

DrawnPart drawn_part(const SurfaceFrame& frame, const Stripe& stripe)
{
    DrawnPart part = {within(stripe.x_px, frame.columns),
                      within(stripe.right_px(), frame.columns),
                      within(stripe.y_px, frame.scanlines),
                      within(stripe.bottom_px(), frame.scanlines),
                      {},
                      false};
    const int32_t x = within(part.left_px - frame.margin, frame.columns);
    const int32_t y = within(part.top_px - frame.margin, frame.scanlines);
    part.rect = {x, y, within(part.right_px + frame.margin, frame.columns) - x,
                 within(part.bottom_px + frame.margin, frame.scanlines) - y};
    part.is_odd = ((x ^ stripe.x_px) & 1) != 0;
    return part;
}

SampleRows samples_of(const SurfaceFrame& frame, const DrawnPart& part, bool are_pixels, void* memory)
{
    const int32_t width = part.rect.width_px << frame.samples_log2, height = part.rect.height_px << frame.samples_log2;
    const uint32_t row_bytes = sample_row_bytes(static_cast<uint32_t>(width), are_pixels ? 2 : 4);
    uint8_t* const bytes = static_cast<uint8_t*>(memory);
    uint8_t* const end = bytes + row_bytes * static_cast<uint32_t>(height);
    return {are_pixels && part.is_odd ? bytes + sizeof(uint16_t) : bytes,
            row_bytes,
            are_pixels ? row_bytes / 2 : row_bytes / 3,
            width,
            height,
            frame.margin != 0 ? reinterpret_cast<uint32_t*>(end) : nullptr};
}

LUMI_HOT void clear_depths(const SampleRows& rows)
{
    uint32_t* at = first_word(rows);
    for (int32_t y = 0; y < rows.height; ++y, at += rows.row_bytes / sizeof *at)
        fill_words(at, rows.colours_at / sizeof *at, 0);
    clear_marks(rows);
}

LUMI_HOT void clear_pixels(const SampleRows& rows, uint16_t pixel)
{
    const uint32_t words = rows.colours_at / sizeof(uint32_t), two = pixel | static_cast<uint32_t>(pixel) << 16;
    uint32_t* at = first_word(rows);
    for (int32_t y = 0; y < rows.height; ++y) at = fill_words(fill_words(at, words, 0), words, two);
    clear_marks(rows);
}

LUMI_HOT void copy_pixels(uint8_t* to_bytes, const uint8_t* from_bytes, uint32_t count)
{
    uint16_t* to = reinterpret_cast<uint16_t*>(to_bytes);
    const uint16_t* from = reinterpret_cast<const uint16_t*>(from_bytes);
    const uintptr_t place = reinterpret_cast<uintptr_t>(to);
    if (((place ^ reinterpret_cast<uintptr_t>(from)) & 3) == 0) {
        if ((place & 2) != 0 && count != 0) {
            *to++ = *from++;
            --count;
        }
        for (; count >= 16; count -= 16, to += 16, from += 16)
            *reinterpret_cast<EightWords*>(to) = *reinterpret_cast<const EightWords*>(from);
    }
    for (; count != 0; --count) *to++ = *from++;
}

}  // namespace lumi::detail
