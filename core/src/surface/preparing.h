// SPDX-License-Identifier: MIT
// The steps of preparing a frame: for any part of a field's vertices, and for any of its patches, whose triangles that
// are seen are put into lists (lists.h). Inlined: what prepares on one core has no calls for the sake of two.
#pragma once

#include "lumi/surface/halves.h"
#include "surface/lists.h"
#include "surface/projection.h"

namespace lumi::detail
{

inline constexpr PlaceRange kNoPlace = {INT32_MAX, INT32_MIN};
inline constexpr PlacedVertices kNoneIsPlaced = {kNoPlace, kNoPlace, true};

inline void empty_bands(const SurfaceFrame& frame, uint16_t* bands)
{
    for (uint32_t k = 0; k <= frame.other_list; ++k) bands[k] = kEmptyBand;
}

LUMI_ALWAYS_INLINE void add(PlaceRange& range, int32_t v)
{
    if (v < range.least) range.least = v;
    if (v > range.most) range.most = v;
}

// The pixels that a range of places in 1/64 sample meets, of `size`, and those beside them that an outline may change.
inline Extent pixels_of(const PlaceRange& q6, uint32_t samples_log2, int32_t size)
{
    if (q6.least > q6.most) return {0, 0};
    const auto within = [&](int32_t v) { return v < 0 ? 0 : v < size ? v : size; };
    const uint32_t shift = 6 + samples_log2;
    return {within((q6.least >> shift) - 1), within((q6.most >> shift) + 2)};
}

// Sets what a frame has from its caller.
LUMI_ALWAYS_INLINE void set_frame(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                                  const SurfaceMemory& memory, SurfaceFrame& out)
{
    out.field = field;
    out.memory = memory;
    out.width_px = camera.width_px;
    out.height_px = camera.height_px;
    out.mode = mode;
    out.samples_log2 = mode == SurfaceMode::two_by_two ? 1 : 0;
    out.margin = mode == SurfaceMode::antialiased && field.neighbours != nullptr ? 1 : 0;
    out.other_list = surface_bands(out.height_px, memory.band_log2) - 1;
}

// Leaves lists without triangles.
LUMI_ALWAYS_INLINE void empty_frame(SurfaceFrame& frame)
{
    empty_bands(frame, frame.memory.bands);
    frame.reach = 0;
    frame.columns = frame.scanlines = {0, 0};
}

// The frame's constants, and lists without triangles; false if the sphere lies behind the near plane, so that nothing
// of it shows.
LUMI_ALWAYS_INLINE bool begin_frame(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode,
                                    const SurfaceMemory& memory, SurfaceFrame& out)
{
    set_frame(field, camera, mode, memory, out);
    empty_frame(out);
    return set_projection(camera, out);
}

// Places these vertices, without their light.
LUMI_ALWAYS_INLINE PlacedVertices put_vertices(const SurfaceFrame& frame, uint32_t begin, uint32_t end,
                                               uint32_t colour = kUnlit)
{
    PlacedVertices placed = kNoneIsPlaced;
    LUMI_TALLY(Work::vertex, end - begin);
    for (uint32_t k = begin; k < end; ++k) {
        const SamplePoint p = projected(frame.projection, view_point(frame.projection, surface_vertex(frame.field, k)));
        frame.memory.vertices[k] = packed(p, colour);
        placed.are_whole = placed.are_whole && p.depth != 0;
        add(placed.x_q6, p.x_q6);
        add(placed.y_q6, p.y_q6);
    }
    return placed;
}

// Comes after all vertices.
LUMI_ALWAYS_INLINE void set_extents(SurfaceFrame& frame, const PlacedVertices& placed)
{
    constexpr int32_t kNarrowQ6 = 46340;  // twice a triangle's area, at most its width times its height, fits 32 bits
    const PlaceRange &x = placed.x_q6, &y = placed.y_q6;
    frame.is_whole = placed.are_whole;
    frame.is_narrow = x.most - x.least < kNarrowQ6 && y.most - y.least < kNarrowQ6;
    frame.columns = placed.are_whole ? pixels_of(x, frame.samples_log2, frame.width_px) : Extent{0, frame.width_px};
    frame.scanlines = placed.are_whole ? pixels_of(y, frame.samples_log2, frame.height_px) : Extent{0, frame.height_px};
}

// A triangle as long as this may be too large for a list, or curved. Of packed numbers.
inline int32_t long_from(const SurfaceFrame& frame)
{
    const int32_t straight_px = frame.projection.straight_px, small_px = kSmallQ6 >> (6 + frame.samples_log2);
    const int32_t length_px = straight_px < small_px ? straight_px : small_px;
    return length_px << (14 + frame.samples_log2);
}

// Takes patches in the order of the file. `kLight` is called for each corner of a triangle that is listed. Several
// cores may have one each, with bands of their own and with patches that no other has.
template <void (*kLight)(const SurfaceFrame&, const SurfaceVertex*)>
class Lister
{
public:
    Lister(const SurfaceFrame& frame, uint16_t* bands)
        : frame_(frame),
          bands_(bands),
          scanlines_(frame.height_px << frame.samples_log2),
          right_(frame.width_px << (frame.samples_log2 + 14)),
          long_from_(long_from(frame)),
          band_log2_(frame.samples_log2 + frame.memory.band_log2)
    {
    }

    // Takes the triangles (a, b, c) and (d, c, b) of a patch.
    LUMI_ALWAYS_INLINE void add(uint32_t patch, const uint32_t (&corner)[4])
    {
        LUMI_TALLY(Work::patch, 1);
        const SurfaceVertex* v = frame_.memory.vertices;
        uint16_t* const links = frame_.memory.links + 2 * patch;
        const SurfaceVertex &a = v[corner[0]], &b = v[corner[1]], &c = v[corner[2]];
        const int32_t x = x_q6(b), y = y_q6(b), across = x_q6(c) - x, down = y_q6(c) - y;
        const auto area_with = [&](const SurfaceVertex& other) {
            const int32_t right = x_q6(other) - x, below = y_q6(other) - y;
            return frame_.is_narrow ? across * below - right * down : wide_sign(across, below, right, down);
        };
        links[0] = links[1] = kTurnedAway;
        if (area_with(a) < 0 || is_cut(a, b, c)) list_triangle(2 * patch, &a, &b, &c);
        if (corner[3] == format::kNoVertex) return;
        const SurfaceVertex& d = v[corner[3]];
        if (area_with(d) > 0 || is_cut(d, c, b)) list_triangle(2 * patch + 1, &d, &c, &b);
    }

    // Bands that a triangle reaches beyond its first, at most.
    int32_t reach() const { return reach_; }

private:
    LUMI_ALWAYS_INLINE bool is_cut(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) const
    {
        return !frame_.is_whole && !Seen{&a, &b, &c}.are_there();
    }

    // One that faces the eye, or is cut.
    __attribute__((noinline)) void list_triangle(uint32_t triangle, const SurfaceVertex* a, const SurfaceVertex* b,
                                                 const SurfaceVertex* c)
    {
        LUMI_TALLY(Work::listed, 1);
        if (is_cut(*a, *b, *c)) {
            put(frame_.other_list, triangle, 0);
        } else if (!list(triangle, {a, b, c})) {
            frame_.memory.links[triangle] = kWithoutSamples;
            return;
        }
        kLight(frame_, a);
        kLight(frame_, b);
        kLight(frame_, c);
    }

    // False if it lies beside the image or between the scanlines.
    LUMI_ALWAYS_INLINE bool list(uint32_t triangle, const Seen& s)
    {
        const int32_t upper = s.upper(), lower = s.lower();
        const int32_t first = line_from_packed(upper), last = line_from_packed(lower);
        const int32_t begin = first > 0 ? first : 0, end = last < scanlines_ ? last : scanlines_;
        if (begin >= end) return false;
        const int32_t left = s.left(), right = s.right();
        if (right < 0 || left > right_) return false;
        const uint32_t band = static_cast<uint32_t>(begin + frame_.margin) >> band_log2_;
        const uint32_t last_band = static_cast<uint32_t>(end - 1 + frame_.margin) >> band_log2_;
        const int32_t reach = static_cast<int32_t>(last_band - band);
        const bool is_short = lower - upper < long_from_ && right - left < long_from_;
        if (reach >= kBandReach || !(is_short || is_small(frame_, s))) {
            put(frame_.other_list, triangle, 0);
            return true;
        }
        const uint32_t nearness = static_cast<uint32_t>(s.a->y & 0xFF) * kBandLists >> 8;
        if (reach > reach_) reach_ = reach;
        put(list_of(band, nearness), triangle, reach);
        return true;
    }

    // Puts a triangle before the others of a list.
    void put(uint32_t list, uint32_t triangle, int32_t reach)
    {
        uint16_t& first = bands_[list];
        const uint32_t next = first == kEmptyBand ? triangle : first;
        frame_.memory.links[triangle] = static_cast<uint16_t>(next | static_cast<uint32_t>(reach) << kLinkBits);
        first = static_cast<uint16_t>(triangle);
    }

    const SurfaceFrame& frame_;
    uint16_t* const bands_;
    const int32_t scanlines_, right_, long_from_;
    const uint32_t band_log2_;
    int32_t reach_ = 0;
};

}  // namespace lumi::detail
