// SPDX-License-Identifier: MIT
// Marks of pixels that an outline cuts: a bit for each of a Target. A marked pixel's depth has in its low bits how
// much of it, in 1/32, shows the colour of a pixel beside it, and below that which one. Colours stay as they are. A
// pixel keeps one of several marks: that of a surface in front goes before that of what lies behind, and a larger one
// before a smaller one. So the order of edges does not matter.
//
// Two more planes have a bit for each pair of a pixel with its right neighbour, and with the one below. It is set where
// an edge passes through the pixel behind. Edges through the pixel in front then lie further in, under the same
// surface, and drop_inner_edges() takes their marks.
#pragma once

#include "lumi/surface/detail/target.h"
#include "lumi/surface/frame.h"

namespace lumi::detail
{

inline constexpr uint32_t kMarkBits = 6, kMostShare = 15;
// A sample shows a colour of its own from this depth on; from kFarDepth on it is a surface's that hides what is behind.
inline constexpr uint32_t kShownDepth = 1u << kMarkBits;
static_assert(kShownDepth <= kFarDepth, "a marked pixel without a surface is still below every depth");
enum class PixelSide : uint8_t { right, left, below, above };  // 1: backwards, 2: along a column

constexpr uint32_t mark_bits(uint32_t share, PixelSide other)
{
    return (share > kMostShare ? kMostShare : share) << 2 | static_cast<uint32_t>(other);
}

inline bool is_marked(const Target& target, int32_t x, int32_t y)
{
    if (target.marks == nullptr) return false;
    const uint32_t column = static_cast<uint32_t>(x);
    const uint32_t word = target.marks[target.marks_words() * static_cast<uint32_t>(y) + column / 32];
    return ((word >> (column & 31)) & 1) != 0;
}

// The mark of a pixel says which other one shows in it, and how much of that, 1/32.
struct Mark {
    const uint16_t *own, *other;
    uint32_t share;

    Mark(const Target& target, int32_t x, int32_t y) : own(target.depths(y) + x), other(own), share(0)
    {
        const uint32_t mark = *own;
        const int32_t step = (mark & 2) != 0 ? static_cast<int32_t>(target.row_bytes / sizeof *own) : 1;
        other += (mark & 1) != 0 ? -step : step;
        share = (mark >> 2) & kMostShare;
    }
    bool has_own() const { return *own >= kShownDepth; }
    bool has_other() const { return *other >= kShownDepth; }
    // The share of the pixel that surfaces cover, 1/32.
    uint32_t covered() const { return (has_own() ? 32 - share : 0) + (has_other() ? share : 0); }
};

// Mixes a colour with so much of another, 1/32: ((32 - share)·a + share·b)/32, rounded. Fields565 has room for that
// above each channel, so one product of its word takes all three.
inline Rgb8 mixed(const Rgb8& a, const Rgb8& b, uint32_t share)
{
    const auto channel = [&](uint32_t p, uint32_t q) {
        return static_cast<uint8_t>((p * (32 - share) + q * share + 16) >> 5);
    };
    return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}
inline Fields565 mixed(Fields565 a, Fields565 b, uint32_t share)
{
    constexpr uint32_t kHalf = 16u << 21 | 16u << 11 | 16u;
    return {((a.word * (32 - share) + b.word * share + kHalf) >> 5) & kFields565};
}

// Mixes the light of two surfaces that share a pixel in the same way. Light is about the square of a level.
LUMI_HOT Rgb8 mixed_light_of(const Rgb8& a, const Rgb8& b, uint32_t share);
LUMI_HOT Fields565 mixed_light_of(Fields565 a, Fields565 b, uint32_t share);

// Where the two are within 32 levels, the mean of their levels stands for that of their light. Then each channel of
// a + 32 - b has none of its upper bits, nor has it borrowed any.
inline Rgb8 mixed_light(const Rgb8& a, const Rgb8& b, uint32_t share)
{
    const auto far = [](int32_t p, int32_t q) { return static_cast<uint32_t>(p - q + 32) > 63; };
    return far(a.r, b.r) || far(a.g, b.g) || far(a.b, b.b) ? mixed_light_of(a, b, share) : mixed(a, b, share);
}
inline Fields565 mixed_light(Fields565 a, Fields565 b, uint32_t share)
{
    constexpr uint32_t kNear = 8u << 21 | 4u << 11 | 4u, kWithin = 15u << 21 | 7u << 11 | 7u;
    return ((a.word + kNear - b.word) & ~kWithin) != 0 ? mixed_light_of(a, b, share) : mixed(a, b, share);
}

// Marks the pixels that an edge cuts, after all triangles are drawn. The edge lies on a triangle that is
// counter-clockwise on the screen, in its order. A crease has a triangle on its other side, too.
LUMI_HOT void mark_edge(const SurfaceVertex& from, const SurfaceVertex& to, bool is_crease, const Target& target);

// Takes the marks of edges that lie further in than another one. Comes after all edges of opaque triangles.
LUMI_HOT void drop_inner_edges(const Target& target);

}  // namespace lumi::detail
