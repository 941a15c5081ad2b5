// SPDX-License-Identifier: MIT
// Frames with see-through triangles take this beside the rest: their triangles, and samples whose depths tell how much
// of the background shows. Before the triangles are drawn the background's colour is put into the samples; over nothing
// (OverNothing) it is black.
//
// A sample without a surface tells in its depth how much of the background shows: below kShownDepth all of it, and
// nothing was drawn there; from there up to kFarDepth - 1, what is between the two is the share that is covered.
#pragma once

#include "lumi/surface/detail/resolve.h"

namespace lumi::detail
{

// Gives the see-through triangles of a frame that reach a target, in their order, as TrianglePieces gives opaque ones.
class SeeThroughPieces
{
public:
    SeeThroughPieces(const SurfaceFrame& frame, const Target& target) : piece(target), frame_(frame), target_(target)
    {
        piece.rows.palette = see_through_palette(frame);
    }

    // Makes `piece` the next one; false after the last.
    LUMI_HOT bool next();

    TrianglePiece piece;

protected:
    // `begin` begins a triangle that is cut.
    template <class Begin>
    LUMI_ALWAYS_INLINE bool next_of(const Begin& begin);

    const SurfaceFrame& frame_;
    const Target& target_;
    uint32_t at_ = 0;
    CutTriangle cut_;
};

// Does so where shadows of parts may move.
class MovingSeeThroughPieces : public SeeThroughPieces
{
public:
    using SeeThroughPieces::SeeThroughPieces;

    LUMI_HOT bool next();
};

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
MixedPair mixed_pair(const Target& target, int32_t x, int32_t y);

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
    const int32_t left = s.target.x >> log2, top = s.target.y >> log2;
    const int32_t begin = (s.covered.x_px - left) << log2, end = begin + (s.covered.width_px << log2);
    const int32_t first = (s.covered.y_px - top) << log2, last = first + (s.covered.height_px << log2);
    for (int32_t y = first; y < last; ++y) {
        PackedColour* const colours = s.target.template colours<PackedColour>(y);
        const uint8_t* const row = pixel_of<Pixel>(s.covered, s.covered.x_px, top + (y >> log2));
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
    const int32_t width = s.target.width, height = s.target.height;
    for (int32_t y = 0; y < height; ++y) {
        PackedColour* const colours = s.target.template colours<PackedColour>(y);
        LUMI_TALLY(Work::see_word, width);
        for (int32_t x = 0; x < width; ++x) colours[x] = under;
    }
    if constexpr (!Background::kFills) fill_from_stripe<Pixel>(s);
}

// Beside an outline a stripe's content behind glass may lie beside the stripe: such pixels keep their own colour.
void unmark_glass(const Target& target);

// Sums up what covers a pixel; false where no glass alone covers some of it.
template <class Samples>
bool covered_by_glass(const Samples& s, int32_t x, int32_t y, CoveredSum& sum)
{
    const auto add = [&](const uint16_t* depth, uint32_t of_255, uint32_t weight) {
        if (*depth >= kShownDepth) sum.add(levels_of(s.colour_at(depth)), of_255, weight);
    };
    if (s.frame.samples_log2 != 0) {
        const uint16_t *const upper = s.target.depths(2 * y) + 2 * x, *const lower = s.target.depths(2 * y + 1) + 2 * x;
        const uint16_t* const depths[] = {upper, upper + 1, lower, lower + 1};
        bool has_glass = false;
        for (const uint16_t* depth : depths) has_glass = has_glass || is_glass_alone(*depth);
        if (!has_glass) return false;
        for (const uint16_t* depth : depths) add(depth, coverage_of(*depth), 1);
        return true;
    }
    const MixedPair pair = mixed_pair(s.target, x, y);
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
    uint8_t* pixel = pixel_of<Pixel>(s.covered, s.covered.x_px, y);
    const int32_t begin = s.covered.x_px - (s.target.x >> log2), row = y - (s.target.y >> log2);
    for (int32_t x = begin; x < begin + s.covered.width_px; ++x, pixel += Pixel::kBytes) {
        CoveredSum sum;
        if (!covered_by_glass(s, x, row, sum)) continue;
        const uint32_t half = 1u << (shift - 1);
        store_part<Pixel>(pixel, sum.colour(), static_cast<uint8_t>((sum.coverage + half) >> shift));
    }
}

// Does what mark_outlines() does for see-through triangles, over a colour that is known beside the target.
void mark_see_through_outlines(const SurfaceFrame& frame, const Target& target);

// Does what store_coverage() does where see-through triangles were drawn.
void store_see_through_coverage(const StripeSamples& samples, int32_t y);

}  // namespace lumi::detail
