// SPDX-License-Identifier: MIT
// This lays out samples in memory and clears, copies and mixes the colours in them.
#include "lumi/surface/detail/resolve.h"

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
    LUMI_TALLY(Work::word, count);
    const EightWords eight = {{value, value, value, value, value, value, value, value}};
    for (; count >= 8; count -= 8, at += 8) *reinterpret_cast<EightWords*>(at) = eight;
    for (; count != 0; --count) *at++ = value;
    return at;
}

uint32_t* first_word(const Target& target)
{
    return reinterpret_cast<uint32_t*>(reinterpret_cast<uintptr_t>(target.first) & ~uintptr_t{3});
}

void clear_marks(const Target& target)
{
    if (target.marks != nullptr)
        fill_words(target.marks, kMarkPlanes * target.marks_words() * static_cast<uint32_t>(target.height), 0);
}

// A field's guard bit; the bits below it are its value.
PackedColour clamped_field(PackedColour sum, uint32_t guard, uint32_t value_bits)
{
    if ((sum & guard) == 0) return sum;
    const PackedColour others = sum & ~(guard | value_bits);
    return (sum & (guard >> 1)) != 0 ? others : others | value_bits;
}

// Rounds to the nearest whole number; v <= (2^kBits - 1)².
template <uint32_t kBits>
LUMI_ALWAYS_INLINE uint32_t root_of(uint32_t v)
{
    uint32_t root = 0;
#pragma GCC unroll 8
    for (uint32_t bit = 1u << (kBits - 1); bit != 0; bit >>= 1) {
        const uint32_t trial = root | bit;
        if (trial * (trial - 1) < v) root = trial;
    }
    return root;
}

template <uint32_t kBits>
LUMI_ALWAYS_INLINE uint32_t mixed_light_of(uint32_t a, uint32_t b, uint32_t share)
{
    return root_of<kBits>((a * a * (32 - share) + b * b * share + 16) >> 5);
}

}  // namespace

Stripe covered_part(const SurfaceFrame& frame, const Stripe& stripe, uint32_t pixel_bytes)
{
    const int32_t left = within(stripe.x_px, frame.columns), right = within(stripe.right_px(), frame.columns);
    const int32_t top = within(stripe.y_px, frame.scanlines), bottom = within(stripe.bottom_px(), frame.scanlines);
    if (left >= right || top >= bottom) return {stripe.pixels, left, top, 0, 0, stripe.stride_bytes};
    uint8_t* const first = stripe.pixels + static_cast<size_t>(top - stripe.y_px) * stripe.stride_bytes +
                           static_cast<uint32_t>(left - stripe.x_px) * pixel_bytes;
    return {first, left, top, right - left, bottom - top, stripe.stride_bytes};
}

Target target_of(const SurfaceFrame& frame, const Stripe& covered, int32_t left_px, bool are_pixels, void* memory)
{
    constexpr int32_t kMagnifiedPx = 3;  // texels larger than so many pixels are read bilinearly in modes that do so
    const uint32_t log2 = frame.samples_log2;
    const int32_t x_px = within(covered.x_px - frame.margin, frame.columns);
    const int32_t y_px = within(covered.y_px - frame.margin, frame.scanlines);
    const int32_t right_px = within(covered.x_px + covered.width_px + frame.margin, frame.columns);
    const int32_t bottom_px = within(covered.y_px + covered.height_px + frame.margin, frame.scanlines);
    LUMI_TALLY(Work::stripe, 1);
    Target t;
    t.width = (right_px - x_px) << log2;
    t.height = (bottom_px - y_px) << log2;
    t.x = x_px << log2;
    t.y = y_px << log2;
    t.row_bytes = sample_row_bytes(static_cast<uint32_t>(t.width), are_pixels ? 2 : 4);
    t.colours_at = are_pixels ? t.row_bytes / 2 : t.row_bytes / 3;
    uint8_t* const bytes = static_cast<uint8_t*>(memory);
    const bool is_odd = ((x_px ^ left_px) & 1) != 0;
    t.first = are_pixels && is_odd ? bytes + sizeof(uint16_t) : bytes;
    uint8_t* const end = bytes + t.row_bytes * static_cast<uint32_t>(t.height);
    t.marks = frame.margin != 0 ? reinterpret_cast<uint32_t*>(end) : nullptr;
    t.palette = frame.palette;
    t.has_two_taps = frame.mode == SurfaceMode::antialiased;
    t.magnified_q10 = frame.mode == SurfaceMode::one_sample ? -1 : (1024 / kMagnifiedPx) >> log2;
    return t;
}

LUMI_HOT void clear_depths(const Target& target)
{
    uint32_t* at = first_word(target);
    for (int32_t y = 0; y < target.height; ++y, at += target.row_bytes / sizeof *at)
        fill_words(at, target.colours_at / sizeof *at, 0);
    clear_marks(target);
}

LUMI_HOT void clear_pixels(const Target& target, uint16_t pixel)
{
    const uint32_t words = target.colours_at / sizeof(uint32_t), two = pixel | static_cast<uint32_t>(pixel) << 16;
    uint32_t* at = first_word(target);
    for (int32_t y = 0; y < target.height; ++y) at = fill_words(fill_words(at, words, 0), words, two);
    clear_marks(target);
}

LUMI_HOT void copy_pixels(uint8_t* to_bytes, const uint8_t* from_bytes, uint32_t count)
{
    LUMI_TALLY(Work::word, count / 2);
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

LUMI_HOT PackedColour mean_light_of(const PackedColour (&c)[4], PackedColour black)
{
    LUMI_TALLY(Work::four_apart, 1);
    const Rgb8 none = unpacked(black);
    uint32_t r = 0, g = 0, b = 0;
    const auto square = [](int32_t v) { return static_cast<uint32_t>(v * v); };
    for (const PackedColour one : c) {
        const Rgb8 levels = unpacked(one);
        r += square(levels.r - none.r);
        g += square(levels.g - none.g);
        b += square(levels.b - none.b);
    }
    return packed_colour(4 * root_of<8>(r >> 2), 4 * root_of<8>(g >> 2), 4 * root_of<8>(b >> 2)) + black;
}

LUMI_HOT Rgb8 mixed_light_of(const Rgb8& a, const Rgb8& b, uint32_t share)
{
    const auto channel = [&](uint32_t p, uint32_t q) { return static_cast<uint8_t>(mixed_light_of<8>(p, q, share)); };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

LUMI_HOT Fields565 mixed_light_of(Fields565 a, Fields565 b, uint32_t share)
{
    // Twice the levels of red and blue, of 6 bits as green's.
    const auto red_or_blue = [&](uint32_t at) {
        const uint32_t p = a.word >> at & 31, q = b.word >> at & 31;
        return (mixed_light_of<6>(2 * p, 2 * q, share) + 1) >> 1 << at;
    };
    return {mixed_light_of<6>(a.word >> 21, b.word >> 21, share) << 21 | red_or_blue(11) | red_or_blue(0)};
}

LUMI_HOT PackedColour lumi_clamped(PackedColour sum)
{
    LUMI_TALLY(Work::clamped, 1);
    sum = clamped_field(sum, 0x80000000, 0x7FE00000);
    sum = clamped_field(sum, 0x00100000, 0x000FFC00);
    return clamped_field(sum, 0x00000200, 0x000001FF);
}

}  // namespace lumi::detail
