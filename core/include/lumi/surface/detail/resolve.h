// SPDX-License-Identifier: MIT
// From samples to pixels: PixelSamples (a sample is the pixel itself), PackedSamples (a sample's colour becomes one)
// and FourSamples (the mean light of four does). Each has `clear`, before triangles are filled, and `resolve`, a
// scanline of the stripe.
#pragma once

#include "lumi/background.h"
#include "lumi/surface/detail/marks.h"
#include "lumi/surface/detail/target.h"

namespace lumi::detail
{

// A stripe's drawn part with its samples.
struct StripeSamples {
    const SurfaceFrame& frame;
    const SampleRows& rows;
    const DrawnPart& part;
    const Stripe& stripe;

    // Columns and rows of samples, for one a pixel.
    int32_t column(int32_t x_px) const { return x_px - part.rect.x_px; }
    int32_t row(int32_t y_px) const { return y_px - part.rect.y_px; }
    int32_t begin() const { return column(part.left_px); }
    int32_t end() const { return column(part.right_px); }
};

// Draws the triangles of a frame with one sample a pixel, in a mode up to kFinest, and marks its outlines.
template <const RowFilters& kFilters, SurfaceMode kFinest>
void draw_one_sample(const SurfaceFrame& frame, const Target& target)
{
    if constexpr (kFinest != SurfaceMode::one_sample) {
        if (frame.mode == SurfaceMode::antialiased) {
            draw_triangles<kFilters.two_taps, kFilters.bilinear>(frame, target);
            if (frame.margin != 0) mark_outlines(frame, target);
            return;
        }
    }
    draw_triangles<kFilters.nearest>(frame, target);
}

// A pixel that an outline cuts: its column of samples, and what shows there.
template <class Colour>
struct Blended {
    int32_t x;
    Colour colour;
    uint8_t coverage;
};

// A marked pixel over a background.
template <class Samples, class Background>
Blended<typename Samples::Colour> blended(const Samples& s, const Mark& mark, int32_t x, const Background& background,
                                          const uint8_t* pixel)
{
    if constexpr (kKeepsCoverage<Background>) {
        // Over nothing: where one of the two is empty, the other's colour with its share.
        const uint32_t covered = mark.covered();
        if (covered == 0) return {x, s.converted({0, 0, 0}), 0};
        const uint16_t* const own = mark.has_own() ? mark.own : mark.other;
        const auto colour = mixed(s.colour_at(own), s.colour_at(mark.has_other() ? mark.other : own), mark.share);
        return {x, colour, static_cast<uint8_t>((covered * 255 + 16) >> 5)};
    } else {
        const auto colour_at = [&](const uint16_t* depth, bool has_surface) {
            if (has_surface) return s.colour_at(depth);
            return s.converted(background.template under<typename Samples::PixelType>(pixel));
        };
        return {x, mixed(colour_at(mark.own, mark.has_own()), colour_at(mark.other, mark.has_other()), mark.share),
                255};
    }
}

// Calls visit(x) for the marked samples of a row from `begin` to `end`.
template <class Visit>
LUMI_ALWAYS_INLINE void each_marked(const SampleRows& rows, int32_t row, int32_t begin, int32_t end, const Visit& visit)
{
    const uint32_t* word = rows.marks + rows.marks_words() * static_cast<uint32_t>(row);
    for (int32_t first = 0; first < end; first += 32) {
        for (uint32_t bits = *word++; bits != 0; bits &= bits - 1) {
            const int32_t x = first + __builtin_ctz(bits);
            if (x >= begin && x < end) visit(x);
        }
    }
}

// Makes a row's pixels, from `pixel` on, where outlines cut some of them. What lies under a pixel is read before any
// pixel up to it is written.
template <class Pixel, class Samples, class Background>
__attribute__((noinline)) void resolve_marked(const Samples& s, const Background& background, uint8_t* pixel,
                                              int32_t row)
{
    constexpr int32_t kMost = 16;
    Blended<typename Samples::Colour> pending[kMost];
    int32_t count = 0, done = s.begin();
    const auto place = [&](int32_t x) { return pixel + (x - s.begin()) * static_cast<int32_t>(Pixel::kBytes); };
    const auto write = [&](int32_t end) {
        s.put(background, place(done), row, done, end);
        for (int32_t k = 0; k < count; ++k) s.store(place(pending[k].x), pending[k].colour, pending[k].coverage);
        count = 0;
        done = end;
    };
    each_marked(s.rows, row, s.begin(), s.end(), [&](int32_t x) {
        if (count == kMost) write(x);
        pending[count++] = blended(s, Mark(s.rows, x, row), x, background, place(x));
    });
    write(s.end());
}

// A scanline of the stripe, of samples that have put(), the pixels of a row from `begin` to `end`; colour_at(), the
// colour of the sample whose depth lies there, as their Colour; and store(), a pixel of that.
template <class Pixel, SurfaceMode kFinest, class Samples, class Background>
LUMI_ALWAYS_INLINE void resolve_one_sample(const Samples& s, const Background& background, int32_t y)
{
    uint8_t* const pixel = pixel_of<Pixel>(s.stripe, s.part.left_px, y);
    if constexpr (kFinest != SurfaceMode::one_sample)
        if (s.rows.marks != nullptr) return resolve_marked<Pixel>(s, background, pixel, s.row(y));
    s.put(background, pixel, s.row(y), s.begin(), s.end());
}

template <class Pixel>
struct PixelSamples : StripeSamples {
    static constexpr bool kArePixels = true;
    using PixelType = Pixel;
    using Colour = Fields565;

    template <class Background>
    void clear(const Background& background) const
    {
        uint16_t pixel = 0;
        if constexpr (Background::kFills && !Background::kIsBlack && !kKeepsCoverage<Background>)
            Pixel::store(reinterpret_cast<uint8_t*>(&pixel), background.template under<Pixel>(nullptr));
        clear_pixels(rows, pixel);
        if constexpr (!Background::kFills)
            for (int32_t y = part.top_px; y < part.bottom_px; ++y)
                copy_pixels(sample(row(y), begin()), pixel_of<Pixel>(stripe, part.left_px, y),
                            static_cast<uint32_t>(end() - begin()));
    }

    template <SurfaceMode kFinest>
    void draw(const Target& target) const
    {
        draw_one_sample<kPixelRows<Pixel>, kFinest>(frame, target);
    }

    template <SurfaceMode kFinest, class Background>
    void resolve(const Background& background, int32_t y) const
    {
        resolve_one_sample<Pixel, kFinest>(*this, background, y);
    }

    template <class Background>
    void put(const Background&, uint8_t* pixel, int32_t row, int32_t begin, int32_t end) const
    {
        copy_pixels(pixel, sample(row, begin), static_cast<uint32_t>(end - begin));
    }
    Colour colour_at(const uint16_t* depth) const
    {
        return apart(Pixel::load_packed(reinterpret_cast<const uint8_t*>(depth) + rows.colours_at));
    }
    static Colour converted(const Rgb8& c) { return apart(pack_rgb565(c)); }
    static void store(uint8_t* pixel, Colour c, uint8_t) { Pixel::store_packed(pixel, together(c)); }

private:
    uint8_t* sample(int32_t row, int32_t x) const
    {
        return reinterpret_cast<uint8_t*>(rows.template colours<uint16_t>(row) + x);
    }
};

// The colour of the sample whose depth lies there.
inline Rgb8 packed_at(const SampleRows& rows, const uint16_t* depth)
{
    const uint32_t before = static_cast<uint32_t>(reinterpret_cast<const uint8_t*>(depth) - rows.first);
    const uint32_t y = before / rows.row_bytes, column = (before - y * rows.row_bytes) / sizeof *depth;
    return unpacked(rows.template colours<PackedColour>(static_cast<int32_t>(y))[column]);
}

template <class Pixel>
struct PackedSamples : StripeSamples {
    static constexpr bool kArePixels = false;
    using PixelType = Pixel;
    using Colour = Rgb8;

    template <class Background>
    void clear(const Background&) const
    {
        clear_depths(rows);
    }

    template <SurfaceMode kFinest>
    void draw(const Target& target) const
    {
        draw_one_sample<kPackedRows, kFinest>(frame, target);
    }

    template <SurfaceMode kFinest, class Background>
    void resolve(const Background& background, int32_t y) const
    {
        resolve_one_sample<Pixel, kFinest>(*this, background, y);
    }

    template <class Background>
    void put(const Background& background, uint8_t* pixel, int32_t row, int32_t begin, int32_t end) const
    {
        const uint16_t* depth_at = rows.depths(row) + begin;
        const PackedColour* colour_at = rows.template colours<PackedColour>(row) + begin;
        for (const uint16_t* const last = rows.depths(row) + end; depth_at != last; ++depth_at, ++colour_at) {
            if (*depth_at >= kShownDepth)
                store_colour<Pixel>(pixel, *colour_at);
            else if (Background::kFills)
                store_background<Pixel>(pixel, background);
            pixel += Pixel::kBytes;
        }
    }
    Rgb8 colour_at(const uint16_t* depth) const { return packed_at(rows, depth); }
    static Colour converted(const Rgb8& c) { return c; }
    static void store(uint8_t* pixel, const Colour& c, uint8_t coverage) { store_part<Pixel>(pixel, c, coverage); }
};

// What modes of one sample a pixel take.
template <class Pixel, bool kArePixels = kIsSample<Pixel>>
struct OneSampleOf {
    using Type = PackedSamples<Pixel>;
};
template <class Pixel>
struct OneSampleOf<Pixel, true> {
    using Type = PixelSamples<Pixel>;
};

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

template <class Pixel>
struct FourSamples : StripeSamples {
    static constexpr bool kArePixels = false;

    template <class Background>
    void clear(const Background&) const
    {
        clear_depths(rows);
    }

    template <SurfaceMode>
    void draw(const Target& target) const
    {
        draw_triangles<kPackedRows.nearest, kPackedRows.bilinear>(frame, target);
    }

    template <SurfaceMode, class Background>
    void resolve(const Background& background, int32_t y) const
    {
        constexpr PackedColour kBlack = palette_colour<Pixel>({0, 0, 0});
        uint8_t* pixel = pixel_of<Pixel>(stripe, part.left_px, y);
        const int32_t upper_row = 2 * row(y), first = 2 * begin();
        const uint16_t *upper = rows.depths(upper_row) + first, *lower = rows.depths(upper_row + 1) + first;
        const PackedColour* above = rows.template colours<PackedColour>(upper_row) + first;
        const PackedColour* below = rows.template colours<PackedColour>(upper_row + 1) + first;
        for (int32_t count = part.right_px - part.left_px; count > 0; --count) {
            if (upper[0] != 0 && upper[1] != 0 && lower[0] != 0 && lower[1] != 0)
                store_colour<Pixel>(pixel, mean_of(above[0], above[1], below[0], below[1], kBlack));
            else if ((upper[0] | upper[1] | lower[0] | lower[1]) != 0)
                if constexpr (kKeepsCoverage<Background>)
                    store_covered_part<Pixel>(pixel, {upper, lower}, {above, below});
                else
                    store_mixed<Pixel>(pixel, background, {upper, lower}, {above, below});
            else if (Background::kFills)
                store_background<Pixel>(pixel, background);
            pixel += Pixel::kBytes;
            upper += 2;
            lower += 2;
            above += 2;
            below += 2;
        }
    }
    Rgb8 colour_at(const uint16_t* depth) const { return packed_at(rows, depth); }
};

// A scanline of coverage, a byte a pixel, from the samples of any of these.
void store_coverage(const StripeSamples& samples, int32_t y);

}  // namespace lumi::detail
