// SPDX-License-Identifier: MIT
// Draws a surface field into stripes of pixels: fills the triangles that reach a stripe into a buffer of depths and
// colours, then turns samples into pixels.
//
//     uint8_t samples[surface_stripe_bytes(240, 16, SurfaceMode::one_sample)];  // at an address divisible by 4
//     render_surface<PixelRgb565>(frame, OverBlack(), stripe, samples);         // frame: prepare_surface, once
//
// A stripe may be any rectangle of the image, or beside it. Stripes may be drawn in any order, and on several cores at
// once with a buffer of samples each. Any rectangle shows the same pixels as any other.
#pragma once
#pragma GCC system_header

#include "lumi/background.h"
#include "lumi/detail/register_hints.h"
#include "lumi/surface/detail/hot.h"
#include "lumi/surface/frame.h"

namespace lumi
{

// Bytes of a stripe's samples: a colour and a depth each. Outlines are blended with the pixels around the stripe.
constexpr uint32_t surface_stripe_bytes(int32_t width_px, int32_t height_px, SurfaceMode mode)
{
    const uint32_t samples = mode == SurfaceMode::two_by_two ? 4 : 1;
    const int32_t margin = mode == SurfaceMode::antialiased ? 2 : 0;
    return static_cast<uint32_t>(width_px + margin) * static_cast<uint32_t>(height_px + margin) * samples *
           static_cast<uint32_t>(sizeof(detail::PackedColour) + sizeof(uint16_t));
}

// The same for every mode up to the finest: the smallest stripes, up to 1 × 5 pixels, take more for the margin of
// `antialiased` than for the samples of `two_by_two`.
constexpr uint32_t surface_stripe_bytes_up_to(int32_t width_px, int32_t height_px, SurfaceMode finest)
{
    constexpr SurfaceMode kModes[] = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};
    uint32_t most = 0;
    for (const SurfaceMode mode : kModes) {
        const uint32_t bytes = surface_stripe_bytes(width_px, height_px, mode);
        if (mode <= finest && bytes > most) most = bytes;
    }
    return most;
}

}  // namespace lumi

namespace lumi::detail
{

struct SampleRect {
    int32_t x_px, y_px, width_px, height_px;  // within the image
};

inline bool blends_outlines(const SurfaceFrame& frame)
{
    return frame.mode == SurfaceMode::antialiased && frame.field.neighbours != nullptr;
}

// Clears the depths and draws every triangle that reaches the rectangle.
LUMI_HOT void rasterize(const SurfaceFrame& frame, const SampleRect& rect, uint16_t* depths, PackedColour* colours);

// The samples of a pixel that some background shows through.
template <class Pixel, class Background>
__attribute__((noinline)) void store_mixed(uint8_t* pixel, const Background& background,
                                           const uint16_t* const (&depths)[2], const PackedColour* const (&colours)[2])
{
    const Rgb8 under = background.template under<Pixel>(pixel);
    uint32_t r = 2, g = 2, b = 2;
    for (int k = 0; k < 4; ++k) {
        const Rgb8 c = depths[k >> 1][k & 1] == kEmptyDepth ? under : unpacked(colours[k >> 1][k & 1]);
        r += c.r;
        g += c.g;
        b += c.b;
    }
    Pixel::store(pixel, {static_cast<uint8_t>(r >> 2), static_cast<uint8_t>(g >> 2), static_cast<uint8_t>(b >> 2)});
}

// The same over nothing: the mean colour of the samples that are covered, and how many they are.
template <class Pixel>
__attribute__((noinline)) void store_covered_part(uint8_t* pixel, const uint16_t* const (&depths)[2],
                                                  const PackedColour* const (&colours)[2])
{
    constexpr uint32_t kShareQ16[] = {0, 65536, 32768, 21846, 16384};
    uint32_t r = 0, g = 0, b = 0, count = 0;
    for (int k = 0; k < 4; ++k) {
        if (depths[k >> 1][k & 1] == kEmptyDepth) continue;
        const Rgb8 c = unpacked(colours[k >> 1][k & 1]);
        r += c.r;
        g += c.g;
        b += c.b;
        ++count;
    }
    const auto mean = [&](uint32_t sum) { return static_cast<uint8_t>((sum * kShareQ16[count] + 32768) >> 16); };
    store_part<Pixel>(pixel, {mean(r), mean(g), mean(b)}, static_cast<uint8_t>((count * 255 + 2) >> 2));
}

// A pixel that an outline cuts is marked by the first guard bit of its colour, or where it is empty by a depth below
// kFarDepth. Its depth's low bits then say how much of it, in 1/32, shows the colour of a pixel beside it, and below
// that which one. The colours of both stay, and of several marks the largest, so the order of edges does not matter.
inline constexpr PackedColour kMarkedColour = 0x80000000;
inline constexpr uint32_t kMarkBits = 6, kMostShare = 15;
enum class PixelSide : uint8_t { right, left, below, above };

constexpr uint32_t mark_bits(uint32_t share, PixelSide other)
{
    return (share > kMostShare ? kMostShare : share) << 2 | static_cast<uint32_t>(other);
}

struct SampleScanline {
    const uint16_t* depths;
    const PackedColour* colours;
    int32_t pitch;          // to the next scanline
    const uint16_t* first;  // of all scanlines
    uint32_t count;         // of all scanlines
};

// What the mark of a pixel says: which one shows in it, and how much of that, 1/32.
struct Mark {
    int32_t other;
    uint32_t share;

    Mark(const SampleScanline& scanline, int32_t x)
    {
        const uint32_t bits = scanline.depths[x];
        const int32_t steps[] = {1, -1, scanline.pitch, -scanline.pitch};
        other = x + steps[bits & 3];
        share = (bits >> 2) & kMostShare;
        // Depths of a hostile field may look like marks.
        if (static_cast<uint32_t>(scanline.depths - scanline.first + other) >= scanline.count) other = x;
    }
    Rgb8 mixed(const Rgb8& a, const Rgb8& b) const
    {
        const auto channel = [&](uint32_t p, uint32_t q) {
            return static_cast<uint8_t>((p * (32 - share) + q * share + 16) >> 5);
        };
        return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
    }
};

template <class Pixel, class Background>
__attribute__((noinline)) void store_marked(uint8_t* pixel, const Background& background,
                                            const SampleScanline& scanline, int32_t x)
{
    const Rgb8 under = background.template under<Pixel>(pixel);
    const auto colour_at = [&](int32_t k) {
        return scanline.depths[k] < kFarDepth ? under : unpacked(scanline.colours[k] & ~kMarkedColour);
    };
    const Mark mark(scanline, x);
    Pixel::store(pixel, mark.mixed(colour_at(x), colour_at(mark.other)));
}

// The same over nothing: where one of the two is empty, the other's colour with its share.
template <class Pixel>
__attribute__((noinline)) void store_marked_part(uint8_t* pixel, const SampleScanline& scanline, int32_t x)
{
    const Mark mark(scanline, x);
    const auto colour_at = [&](int32_t k) { return unpacked(scanline.colours[k] & ~kMarkedColour); };
    const bool has_own = scanline.depths[x] >= kFarDepth, has_other = scanline.depths[mark.other] >= kFarDepth;
    const uint32_t covered = (has_own ? 32 - mark.share : 0) + (has_other ? mark.share : 0);
    const Rgb8 colour = mark.mixed(colour_at(has_own ? x : mark.other), colour_at(has_other ? mark.other : x));
    store_part<Pixel>(pixel, covered != 0 ? colour : Rgb8{0, 0, 0}, static_cast<uint8_t>((covered * 255 + 16) >> 5));
}

template <class Pixel, class Background>
void resolve_scanline(const Background& background, uint8_t* pixel, int32_t count, const SampleScanline& scanline)
{
    const uint16_t* depth_at = scanline.depths;
    const PackedColour* colour_at = scanline.colours;
    for (const uint16_t* const end = depth_at + count; depth_at != end; ++depth_at, ++colour_at) {
        const uint32_t depth = *depth_at;
        const PackedColour colour = *colour_at;
        if (depth >= kFarDepth && (colour & kMarkedColour) == 0) {
            store_colour<Pixel>(pixel, colour);
        } else if (depth != kEmptyDepth) {
            const int32_t x = static_cast<int32_t>(depth_at - scanline.depths);
            if constexpr (kKeepsCoverage<Background>)
                store_marked_part<Pixel>(pixel, scanline, x);
            else
                store_marked<Pixel>(pixel, background, scanline, x);
        } else if (Background::kFills) {
            store_background<Pixel>(pixel, background);
        }
        pixel += Pixel::kBytes;
    }
}

template <class Pixel, class Background>
void resolve_two_by_two(const Background& background, uint8_t* pixel, int32_t count, const uint16_t* depths,
                        const PackedColour* colours)
{
    constexpr PackedColour kBlack = palette_colour<Pixel>({0, 0, 0});
    for (int32_t x = 0; x < count; ++x, pixel += Pixel::kBytes, depths += 2, colours += 2) {
        const uint16_t *upper = depths, *lower = depths + 2 * count;
        const PackedColour *above = colours, *below = colours + 2 * count;
        if (upper[0] != 0 && upper[1] != 0 && lower[0] != 0 && lower[1] != 0)
            store_colour<Pixel>(pixel, mean_of(above[0], above[1], below[0], below[1], kBlack));
        else if ((upper[0] | upper[1] | lower[0] | lower[1]) != 0)
            if constexpr (kKeepsCoverage<Background>)
                store_covered_part<Pixel>(pixel, {upper, lower}, {above, below});
            else
                store_mixed<Pixel>(pixel, background, {upper, lower}, {above, below});
        else if (Background::kFills)
            store_background<Pixel>(pixel, background);
    }
}

// Fills the samples of a stripe, unless they are there already, and makes pixels of them.
template <class Pixel, bool kFillsSamples, class Background>
LUMI_ALWAYS_INLINE void draw_stripe(const SurfaceFrame& frame, const Background& background, const Stripe& stripe,
                                    void* samples)
{
    const auto clamped_to = [](int32_t v, const Extent& r) { return v < r.begin ? r.begin : v < r.end ? v : r.end; };
    const int32_t left = clamped_to(stripe.x_px, frame.columns), right = clamped_to(stripe.right_px(), frame.columns);
    const int32_t top = clamped_to(stripe.y_px, frame.scanlines),
                  bottom = clamped_to(stripe.bottom_px(), frame.scanlines);
    const bool is_drawn = left < right && top < bottom;
    const int32_t margin = blends_outlines(frame) ? 1 : 0;
    const int32_t from_x = clamped_to(left - margin, frame.columns), from_y = clamped_to(top - margin, frame.scanlines);
    const SampleRect rect = {from_x, from_y, clamped_to(right + margin, frame.columns) - from_x,
                             clamped_to(bottom + margin, frame.scanlines) - from_y};
    const uint32_t scanline_samples = static_cast<uint32_t>(rect.width_px) << (2 * frame.samples_log2);
    const uint32_t count = scanline_samples * static_cast<uint32_t>(rect.height_px);
    PackedColour* colours = static_cast<PackedColour*>(samples);
    uint16_t *depths = nullptr, *first = nullptr;
    if (is_drawn) {
        depths = first = reinterpret_cast<uint16_t*>(colours + count);
        if (kFillsSamples) rasterize(frame, rect, depths, colours);
        const uint32_t before =
            static_cast<uint32_t>(top - from_y) * scanline_samples + static_cast<uint32_t>(left - from_x);
        depths += before;
        colours += before;
    }
    for (int32_t y = stripe.y_px; y < stripe.bottom_px(); ++y) {
        const bool has_scanline = is_drawn && y >= top && y < bottom;
        fill_beside<Pixel>(background, stripe, has_scanline ? Extent{left, right} : Extent{stripe.x_px, stripe.x_px},
                           y);
        if (!has_scanline) continue;
        uint8_t* const pixel = pixel_of<Pixel>(stripe, left, y);
        if (frame.samples_log2 == 0)
            resolve_scanline<Pixel>(background, pixel, right - left, {depths, colours, rect.width_px, first, count});
        else
            resolve_two_by_two<Pixel>(background, pixel, right - left, depths, colours);
        depths += scanline_samples;
        colours += scanline_samples;
    }
}

}  // namespace lumi::detail

namespace lumi
{

// Draws every pixel of the stripe: over a constant colour all of them are written, over the stripe's own content only
// those that the surface covers. `samples`: surface_stripe_bytes() of the stripe, at an address divisible by 4.
template <class Pixel, class Background>
void render_surface(const SurfaceFrame& frame, const Background& background, const Stripe& stripe, void* samples)
{
    detail::draw_stripe<Pixel, true>(frame, background, stripe, samples);
}

// The coverage of the stripe that render_surface drew last into these samples, a byte a pixel: `coverage` has that
// stripe's place and size in the image. Colours over nothing and this are the planes of LVGL's RGB565A8.
inline void render_coverage(const SurfaceFrame& frame, const Stripe& coverage, void* samples)
{
    detail::draw_stripe<PixelA8, false>(frame, OverNothing{}, coverage, samples);
}

}  // namespace lumi
