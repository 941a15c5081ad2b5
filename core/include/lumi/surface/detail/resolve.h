// SPDX-License-Identifier: MIT
// From samples to pixels: PixelSamples (a sample is the pixel itself), PackedSamples (a sample's colour becomes one)
// and FourSamples (the mean light of four does). Each names the loops that draw its samples, and has `clear`, before
// triangles are drawn, and `resolve`, a scanline of the stripe.
#pragma once

#include "lumi/background.h"
#include "lumi/surface/detail/gloss.h"
#include "lumi/surface/detail/marks.h"

namespace lumi::detail
{

// The part of a stripe that the surface may cover.
Stripe covered_part(const SurfaceFrame& frame, const Stripe& stripe, uint32_t pixel_bytes);

// The samples of such a part in the caller's memory: with outlines one more on every side, as far as there are any.
// Samples that are pixels have the place in a word that those of the whole stripe have, which begins at column
// `left_px` of the image, if the stripe's first pixel lies at the start of one.
Target target_of(const SurfaceFrame& frame, const Stripe& covered, int32_t left_px, bool are_pixels, void* memory);

// Sets the depths of all samples to kEmptyDepth and clears their marks.
LUMI_HOT void clear_depths(const Target& target);
// Does that, and sets the colours of samples that are pixels.
LUMI_HOT void clear_pixels(const Target& target, uint16_t pixel);
// Copies pixels; best where both lie equally in a word.
LUMI_HOT void copy_pixels(uint8_t* to, const uint8_t* from, uint32_t count);
// Marks the pixels that outlines cut after triangles were drawn, where the target has marks and these are clear.
LUMI_HOT void mark_outlines(const SurfaceFrame& frame, const Target& target);

// A stripe's covered part with its samples.
struct StripeSamples {
    const SurfaceFrame& frame;
    const Target& target;
    const Stripe& covered;

    // Return columns and rows of samples, for one a pixel.
    int32_t begin() const { return covered.x_px - target.x; }
    int32_t end() const { return begin() + covered.width_px; }
    int32_t row(int32_t y_px) const { return y_px - target.y; }
};

// A pixel that an outline cuts: its column of samples, and what shows there.
template <class Colour>
struct Blended {
    int32_t x;
    Colour colour;
    uint8_t coverage;
};

// Lays a marked pixel over a background.
template <class Samples, class Background>
Blended<typename Samples::Colour> blended(const Samples& s, const Mark& mark, int32_t x, const Background& background,
                                          const uint8_t* pixel)
{
    LUMI_TALLY(Work::marked, 1);
    if constexpr (kKeepsCoverage<Background>) {
        // Over nothing: where one of the two is empty, the other's colour with its share.
        const uint32_t covered = mark.covered();
        if (covered == 0) return {x, s.converted({0, 0, 0}), 0};
        const uint16_t* const own = mark.has_own() ? mark.own : mark.other;
        const auto colour = mixed_light(s.colour_at(own), s.colour_at(mark.has_other() ? mark.other : own), mark.share);
        return {x, colour, static_cast<uint8_t>((covered * 255 + 16) >> 5)};
    } else {
        if (mark.has_own() && mark.has_other())
            return {x, mixed_light(s.colour_at(mark.own), s.colour_at(mark.other), mark.share), 255};
        const auto under = s.converted(background.template under<typename Samples::PixelType>(pixel));
        return {x,
                mixed(mark.has_own() ? s.colour_at(mark.own) : under,
                      mark.has_other() ? s.colour_at(mark.other) : under, mark.share),
                255};
    }
}

// Calls visit(x) for the marked samples of a row from `begin` to `end`.
template <class Visit>
LUMI_ALWAYS_INLINE void each_marked(const Target& target, int32_t row, int32_t begin, int32_t end, const Visit& visit)
{
    const uint32_t* word = target.marks + target.marks_words() * static_cast<uint32_t>(row);
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
    const int32_t begin = s.begin(), last = s.end();
    int32_t count = 0, done = begin;
    const auto place = [&](int32_t x) { return pixel + (x - begin) * static_cast<int32_t>(Pixel::kBytes); };
    const auto write = [&](int32_t end) {
        s.put(background, place(done), row, done, end);
        for (int32_t k = 0; k < count; ++k) s.store(place(pending[k].x), pending[k].colour, pending[k].coverage);
        count = 0;
        done = end;
    };
    each_marked(s.target, row, begin, last, [&](int32_t x) {
        if (count == kMost) write(x);
        pending[count++] = blended(s, Mark(s.target, x, row), x, background, place(x));
    });
    write(last);
}

// A scanline of the stripe, of samples that have put(), the pixels of a row from `begin` to `end`; colour_at(), the
// colour of the sample whose depth lies there, as their Colour; and store(), a pixel of that.
template <class Pixel, SurfaceMode kFinest, class Samples, class Background>
LUMI_ALWAYS_INLINE void resolve_one_sample(const Samples& s, const Background& background, int32_t y)
{
    uint8_t* const pixel = pixel_of<Pixel>(s.covered, s.covered.x_px, y);
    if constexpr (kFinest != SurfaceMode::one_sample)
        if (s.target.marks != nullptr) return resolve_marked<Pixel>(s, background, pixel, s.row(y));
    s.put(background, pixel, s.row(y), s.begin(), s.end());
}

template <class Pixel>
struct PixelSamples : StripeSamples {
    static constexpr bool kArePixels = true;
    static constexpr const RowFilters& kRows = kPixelRows<Pixel>;
    static constexpr const RowFilters& kBlends = kPixelBlends<Pixel>;
    static constexpr const GlossFilters& kGloss = kPixelGloss<Pixel>;
    static constexpr int32_t kSide = 1;  // samples a side of a pixel
    // In the mode of one tap no texture is read bilinearly.
    static constexpr DrawRows kMagnifiedRows = kRows.nearest, kMagnifiedBlends = kBlends.nearest;
    static constexpr DrawGlossRows kMagnifiedGloss = kGloss.nearest;
    using PixelType = Pixel;
    using Colour = Fields565;

    template <class Background>
    void clear(const Background& background) const
    {
        uint16_t pixel = 0;
        if constexpr (Background::kFills && !Background::kIsBlack && !kKeepsCoverage<Background>)
            Pixel::store(reinterpret_cast<uint8_t*>(&pixel), background.template under<Pixel>(nullptr));
        clear_pixels(target, pixel);
        if constexpr (!Background::kFills)
            for (int32_t y = covered.y_px; y < covered.y_px + covered.height_px; ++y)
                copy_pixels(sample(row(y), begin()), pixel_of<Pixel>(covered, covered.x_px, y),
                            static_cast<uint32_t>(covered.width_px));
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
        return apart(Pixel::load_packed(reinterpret_cast<const uint8_t*>(depth) + target.colours_at));
    }
    static Colour converted(const Rgb8& c) { return apart(pack_rgb565(c)); }
    static void store(uint8_t* pixel, Colour c, uint8_t) { Pixel::store_packed(pixel, together(c)); }

private:
    uint8_t* sample(int32_t row, int32_t x) const
    {
        return reinterpret_cast<uint8_t*>(target.template colours<uint16_t>(row) + x);
    }
};

// The colour of the sample whose depth lies there.
inline Rgb8 packed_at(const Target& target, const uint16_t* depth)
{
    const uint32_t before = static_cast<uint32_t>(reinterpret_cast<const uint8_t*>(depth) - target.first);
    const uint32_t y = before / target.row_bytes, column = (before - y * target.row_bytes) / sizeof *depth;
    return unpacked(target.template colours<PackedColour>(static_cast<int32_t>(y))[column]);
}

template <class Pixel>
struct PackedSamples : StripeSamples {
    static constexpr bool kArePixels = false;
    static constexpr const RowFilters& kRows = kPackedRows;
    static constexpr const RowFilters& kBlends = kPackedBlends;
    static constexpr const GlossFilters& kGloss = kPackedGloss;
    static constexpr int32_t kSide = 1;
    static constexpr DrawRows kMagnifiedRows = kRows.nearest, kMagnifiedBlends = kBlends.nearest;
    static constexpr DrawGlossRows kMagnifiedGloss = kGloss.nearest;
    using PixelType = Pixel;
    using Colour = Rgb8;

    template <class Background>
    void clear(const Background&) const
    {
        clear_depths(target);
    }

    template <SurfaceMode kFinest, class Background>
    void resolve(const Background& background, int32_t y) const
    {
        resolve_one_sample<Pixel, kFinest>(*this, background, y);
    }

    template <class Background>
    void put(const Background& background, uint8_t* pixel, int32_t row, int32_t begin, int32_t end) const
    {
        const uint16_t* depth_at = target.depths(row) + begin;
        const PackedColour* colour_at = target.template colours<PackedColour>(row) + begin;
        for (const uint16_t* const last = target.depths(row) + end; depth_at != last; ++depth_at, ++colour_at) {
            if (*depth_at >= kShownDepth)
                store_colour<Pixel>(pixel, *colour_at);
            else if (Background::kFills)
                store_background<Pixel>(pixel, background);
            pixel += Pixel::kBytes;
        }
    }
    Rgb8 colour_at(const uint16_t* depth) const { return packed_at(target, depth); }
    static Colour converted(const Rgb8& c) { return c; }
    static void store(uint8_t* pixel, const Colour& c, uint8_t coverage) { store_part<Pixel>(pixel, c, coverage); }
};

template <class Samples>
struct KindOf {
    using Type = Samples;
};
// Names the samples of modes of one sample a pixel.
template <class Pixel, bool kArePixels = kIsSample<Pixel>>
struct OneSampleOf : KindOf<PackedSamples<Pixel>> {
};
template <class Pixel>
struct OneSampleOf<Pixel, true> : KindOf<PixelSamples<Pixel>> {
};

// The samples of a pixel that some background shows through.
template <class Pixel, class Background>
__attribute__((noinline)) void store_mixed(uint8_t* pixel, const Background& background,
                                           const uint16_t* const (&depths)[2], const PackedColour* const (&colours)[2])
{
    LUMI_TALLY(Work::four_mixed, 1);
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

// Stores a pixel over nothing: the mean colour of the samples that are covered, and how many they are.
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
    static constexpr const RowFilters& kRows = kPackedRows;
    static constexpr const RowFilters& kBlends = kPackedBlends;
    static constexpr const GlossFilters& kGloss = kPackedGloss;
    static constexpr int32_t kSide = 2;
    static constexpr DrawRows kMagnifiedRows = kRows.bilinear, kMagnifiedBlends = kBlends.bilinear;
    static constexpr DrawGlossRows kMagnifiedGloss = kGloss.bilinear;

    template <class Background>
    void clear(const Background&) const
    {
        clear_depths(target);
    }

    template <SurfaceMode, class Background>
    __attribute__((noinline)) void resolve(const Background& background, int32_t y) const
    {
        constexpr PackedColour kBlack = palette_colour<Pixel>({0, 0, 0});
        uint8_t* pixel = pixel_of<Pixel>(covered, covered.x_px, y);
        const int32_t upper_row = 2 * (y - covered.y_px);  // there is no margin
        const uint16_t *upper = target.depths(upper_row), *lower = target.depths(upper_row + 1);
        const PackedColour* above = target.template colours<PackedColour>(upper_row);
        const PackedColour* below = target.template colours<PackedColour>(upper_row + 1);
        LUMI_TALLY(Work::four, covered.width_px);
        for (int32_t count = covered.width_px; count > 0; --count) {
            LUMI_TALLY(Work::four_whole, upper[0] != 0 && upper[1] != 0 && lower[0] != 0 && lower[1] != 0);
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
    Rgb8 colour_at(const uint16_t* depth) const { return packed_at(target, depth); }
};

// Stores a scanline of coverage, a byte a pixel, from the samples of any of these.
void store_coverage(const StripeSamples& samples, int32_t y);

}  // namespace lumi::detail
