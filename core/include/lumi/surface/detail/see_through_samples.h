// SPDX-License-Identifier: MIT
// From samples to pixels where see-through triangles were drawn over them. Before that the background's colour is in
// the samples; over nothing (OverNothing) it is black, and the depths tell how much of a sample is covered.
#pragma once

#include "lumi/surface/detail/resolve.h"
#include "lumi/surface/detail/see_through.h"

namespace lumi::detail
{

// How much of a sample without a surface is covered, as its depth says it: kMostClear, which is nothing, to 0.
inline constexpr uint32_t kMostClear = kFarDepth - 1 - kShownDepth;

constexpr bool is_glass_alone(uint32_t depth)
{
    return depth >= kShownDepth && depth < kFarDepth;
}

// How much of a sample is covered, 0 .. 255; of depths that are not marked.
LUMI_ALWAYS_INLINE uint32_t coverage_of(uint32_t depth)
{
    constexpr uint32_t kHalf = kMostClear / 2;
    if (depth >= kFarDepth) return 255;
    if (depth < kShownDepth) return 0;
    return quotient<kMostClear, kMostClear * 255 + kHalf>((depth - kShownDepth) * 255 + kHalf);
}

// Two samples whose colours mix in a pixel of one sample, in 1/32; of a pixel that no outline cuts both are its own.
struct MixedPair {
    const uint16_t *own, *other;
    uint32_t share;  // of the other
    bool is_marked;

    bool has_glass() const { return is_glass_alone(*own) || (share != 0 && is_glass_alone(*other)); }
    uint32_t own_coverage() const { return coverage(*own, is_marked); }
    // Whether the other one is marked is not known: its upper bits tell enough.
    uint32_t other_coverage() const { return coverage(*other, true); }

private:
    // A mark has taken the lower bits of a depth.
    static uint32_t coverage(uint32_t depth, bool is_marked)
    {
        constexpr uint32_t kMarkMask = (1u << kMarkBits) - 1, kMiddle = 1u << (kMarkBits - 1);
        return coverage_of(is_marked && is_glass_alone(depth) ? (depth & ~kMarkMask) + kMiddle : depth);
    }
};
MixedPair mixed_pair(const SampleRows& rows, int32_t x, int32_t y);

// Sums of what covers a pixel, and what that makes of it.
struct CoveredSum {
    uint32_t r = 0, g = 0, b = 0, coverage = 0;

    // A colour that is already multiplied by its coverage.
    void add(const Rgb8& c, uint32_t of_255, uint32_t weight)
    {
        r += weight * c.r;
        g += weight * c.g;
        b += weight * c.b;
        coverage += weight * of_255;
    }
    Rgb8 colour() const { return {channel(r), channel(g), channel(b)}; }

private:
    uint8_t channel(uint32_t sum) const
    {
        const uint32_t level = coverage == 0 ? 0 : sum * 255 / coverage;
        return static_cast<uint8_t>(level < 255 ? level : 255);
    }
};

// Puts a stripe's own content into the samples of its pixels.
template <class Pixel>
void fill_from_stripe(const StripeSamples& s)
{
    const uint32_t log2 = s.frame.samples_log2;
    const int32_t begin = s.begin() << log2, end = s.end() << log2;
    for (int32_t y = s.row(s.part.top_px) << log2; y < s.row(s.part.bottom_px) << log2; ++y) {
        PackedColour* const colours = s.rows.template colours<PackedColour>(y);
        const uint8_t* const row = pixel_of<Pixel>(s.stripe, s.part.left_px, s.part.rect.y_px + (y >> log2));
        for (int32_t x = begin; x < end; ++x)
            colours[x] =
                palette_colour<Pixel>(Pixel::load(row + ((x - begin) >> log2) * static_cast<int32_t>(Pixel::kBytes)));
    }
}

// Puts what lies behind the surface into all samples: black where that is not known.
template <class Pixel, class Background>
void fill_colours(const StripeSamples& s, const Background& background)
{
    PackedColour under = palette_colour<Pixel>({0, 0, 0});
    if constexpr (Background::kFills && !kKeepsCoverage<Background>)
        under = palette_colour<Pixel>(background.template under<Pixel>(nullptr));
    for (int32_t y = 0; y < s.rows.height; ++y) {
        PackedColour* const colours = s.rows.template colours<PackedColour>(y);
        for (int32_t x = 0; x < s.rows.width; ++x) colours[x] = under;
    }
    if constexpr (!Background::kFills) fill_from_stripe<Pixel>(s);
}

// Beside an outline a stripe's content behind glass may lie beside the stripe: such pixels keep their own colour.
void unmark_glass(const SampleRows& rows);

// What of a pixel is covered, where glass alone covers some of it.
template <class Samples>
bool covered_by_glass(const Samples& s, int32_t x, int32_t y, CoveredSum& sum)
{
    const auto add = [&](const uint16_t* depth, uint32_t of_255, uint32_t weight) {
        if (*depth >= kShownDepth) sum.add(levels_of(s.colour_at(depth)), of_255, weight);
    };
    if (s.frame.samples_log2 != 0) {
        const uint16_t *const upper = s.rows.depths(2 * y) + 2 * x, *const lower = s.rows.depths(2 * y + 1) + 2 * x;
        const uint16_t* const depths[] = {upper, upper + 1, lower, lower + 1};
        bool has_glass = false;
        for (const uint16_t* depth : depths) has_glass = has_glass || is_glass_alone(*depth);
        if (!has_glass) return false;
        for (const uint16_t* depth : depths) add(depth, coverage_of(*depth), 1);
        return true;
    }
    const MixedPair pair = mixed_pair(s.rows, x, y);
    if (!pair.has_glass()) return false;
    add(pair.own, pair.own_coverage(), 32 - pair.share);
    add(pair.other, pair.other_coverage(), pair.share);
    return true;
}

// Where glass alone covers some of a scanline's pixels, writes these over.
template <class Pixel, class Samples>
void store_glass(const Samples& s, int32_t y)
{
    const uint32_t log2 = s.frame.samples_log2, shift = log2 != 0 ? 2 : 5;
    uint8_t* pixel = pixel_of<Pixel>(s.stripe, s.part.left_px, y);
    for (int32_t x = s.begin(); x < s.end(); ++x, pixel += Pixel::kBytes) {
        CoveredSum sum;
        if (!covered_by_glass(s, x, s.row(y), sum)) continue;
        const uint32_t half = 1u << (shift - 1);
        store_part<Pixel>(pixel, sum.colour(), static_cast<uint8_t>((sum.coverage + half) >> shift));
    }
}

// Opaque triangles, those that are seen through, and outlines of the opaque ones, or of both.
template <class Pixel, SurfaceMode kFinest, bool kArePixels, bool kMarksBoth>
void draw_both(const SeeThroughFrame& frame, const Target& target)
{
    constexpr const RowFilters& kOpaque = kArePixels ? kPixelRows<Pixel> : kPackedRows;
    constexpr const RowFilters& kBlends = kArePixels ? kPixelBlends<Pixel> : kPackedBlends;
    if constexpr (kFinest != SurfaceMode::one_sample) {
        if (frame.mode == SurfaceMode::antialiased) {
            draw_triangles<kOpaque.two_taps, kOpaque.bilinear>(frame, target);
            blend_triangles<kBlends.two_taps, kBlends.bilinear>(frame, target);
            if (frame.margin != 0) mark_outlines(frame, target);
            if constexpr (kMarksBoth)
                if (frame.margin != 0) mark_see_through_outlines(frame, target);
            return;
        }
    }
    if constexpr (kFinest == SurfaceMode::two_by_two && !kArePixels) {
        if (frame.mode == SurfaceMode::two_by_two) {
            draw_triangles<kOpaque.nearest, kOpaque.bilinear>(frame, target);
            blend_triangles<kBlends.nearest, kBlends.bilinear>(frame, target);
            return;
        }
    }
    draw_triangles<kOpaque.nearest>(frame, target);
    blend_triangles<kBlends.nearest>(frame, target);
}

// As draw_part.
template <class Samples, class Pixel, SurfaceMode kFinest, class Background>
void draw_see_through_part(const SeeThroughFrame& frame, const Background& background, const Stripe& stripe,
                           const DrawnPart& part, void* memory)
{
    const SampleRows rows = samples_of(frame, part, Samples::kArePixels, memory);
    const Samples samples = {{frame, rows, part, stripe}};
    samples.clear(background);
    if constexpr (!Samples::kArePixels) fill_colours<Pixel>(samples, background);
    // A mark would take most of what tells a sample's coverage, and a stripe's content beside it is not known.
    constexpr bool kMarksBoth = Background::kFills && !kKeepsCoverage<Background>;
    draw_both<Pixel, kFinest, Samples::kArePixels, kMarksBoth>(frame, target_of(frame, part, rows));
    if constexpr (!Background::kFills)
        if (rows.marks != nullptr) unmark_glass(rows);
    for (int32_t y = part.top_px; y < part.bottom_px; ++y) {
        samples.template resolve<kFinest>(background, y);
        if constexpr (kKeepsCoverage<Background>) store_glass<Pixel>(samples, y);
    }
}

// As store_coverage.
void store_see_through_coverage(const StripeSamples& samples, int32_t y);

}  // namespace lumi::detail
