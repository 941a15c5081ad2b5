// SPDX-License-Identifier: MIT
// A frame's vertices and lists of triangles.
#include "lumi/surface/detail/view_nodes.h"
#include "surface/seen.h"
#include "surface/sides.h"

namespace lumi::detail
{
namespace
{

static_assert(2 * format::kMaxPatches <= kLinkMask + 1, "a link holds every triangle's number");
static_assert(kBandReach <= 1 << (16 - kLinkBits), "and how far it reaches");

// Three signed fields of 10 bits below each other, see red_q2.
uint32_t packed_fields(int32_t r_q2, int32_t g_q2, int32_t b_q2)
{
    const auto field = [](int32_t v) { return static_cast<uint32_t>(v < -511 ? -511 : v > 511 ? 511 : v) & 0x3FF; };
    return field(r_q2) << 22 | field(g_q2) << 12 | field(b_q2) << 2;
}

}  // namespace

uint32_t lit_colour(const SurfaceFrame& frame, uint32_t vertex)
{
    if (vertex >= frame.field.viewed_count) return 0;
    const uint8_t* record = frame.field.views + vertex * format::kViewBytes;
    const auto number = [](const uint8_t* p) { return static_cast<int32_t>(static_cast<int8_t>(*p)); };
    const SurfaceProjection& p = frame.projection;
    const VertexQ14 v = surface_vertex(frame.field, vertex);
    const ViewDirection to_eye = {p.viewer.x - (v.x >> p.viewer_shift), p.viewer.y - (v.y >> p.viewer_shift),
                                  p.viewer.z - (v.z >> p.viewer_shift)};
    const ViewDirection d = in_view_frame(to_eye, number(record), number(record + 1), number(record + 2));
    const ViewTaps taps = view_taps(d.x, d.y, d.z);
    int32_t r = 0, g = 0, b = 0;
    for (int m = 0; m < 3; ++m) {
        const uint32_t node = taps.node[m];
        const uint32_t index = (record[format::view::kNodesAt + (node >> 1)] >> (4 * (node & 1))) & 15;
        const uint8_t* colour =
            frame.field.node_colours + (node * format::kNodeColours + index) * format::kNodeColourBytes;
        const int32_t weight = taps.weight_q8[m];
        r += weight * number(colour);
        g += weight * number(colour + 1);
        b += weight * number(colour + 2);
    }
    // Weights have 8 bits of fraction, gains 6, the result 2.
    const int32_t gain = record[format::view::kGainAt];
    return packed_fields((r * gain + 2048) >> 12, (g * gain + 2048) >> 12, (b * gain + 2048) >> 12);
}

namespace
{

// Puts a triangle before the others of a list.
void put(SurfaceFrame& frame, uint32_t list, uint32_t triangle, int32_t reach)
{
    uint16_t& first = frame.memory.bands[list];
    const uint32_t next = first == kEmptyBand ? triangle : first;
    frame.memory.links[triangle] = static_cast<uint16_t>(next | static_cast<uint32_t>(reach) << kLinkBits);
    first = static_cast<uint16_t>(triangle);
}

// A triangle as long as this may be too large for a list, or curved. Of packed numbers.
int32_t long_from(const SurfaceFrame& frame)
{
    const int32_t straight_px = frame.projection.straight_px, small_px = kSmallQ6 >> (6 + frame.samples_log2);
    const int32_t length_px = straight_px < small_px ? straight_px : small_px;
    return length_px << (14 + frame.samples_log2);
}

class Lister
{
public:
    explicit Lister(SurfaceFrame& frame)
        : frame_(frame),
          scanlines_(frame.height_px << frame.samples_log2),
          right_(frame.width_px << (frame.samples_log2 + 14)),
          long_from_(long_from(frame)),
          band_log2_(frame.samples_log2 + frame.memory.band_log2)
    {
    }

    // The triangles (a, b, c) and (d, c, b) of a patch.
    LUMI_ALWAYS_INLINE void add(uint32_t patch, const uint32_t (&corner)[4])
    {
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

private:
    LUMI_ALWAYS_INLINE bool is_cut(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) const
    {
        return !frame_.is_whole && !Seen{&a, &b, &c}.are_there();
    }

    // One that faces the eye, or is cut.
    __attribute__((noinline)) void list_triangle(uint32_t triangle, const SurfaceVertex* a, const SurfaceVertex* b,
                                                 const SurfaceVertex* c)
    {
        if (is_cut(*a, *b, *c)) {
            put(frame_, frame_.other_list, triangle, 0);
        } else if (!list(triangle, {a, b, c})) {
            frame_.memory.links[triangle] = kWithoutSamples;
            return;
        }
        light(frame_, a);
        light(frame_, b);
        light(frame_, c);
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
            put(frame_, frame_.other_list, triangle, 0);
            return true;
        }
        const uint32_t nearness = static_cast<uint32_t>(s.a->y & 0xFF) * kBandLists >> 8;
        if (reach > frame_.reach) frame_.reach = reach;
        put(frame_, list_of(band, nearness), triangle, reach);
        return true;
    }

    SurfaceFrame& frame_;
    const int32_t scanlines_, right_, long_from_;
    const uint32_t band_log2_;
};

struct Range {
    int32_t least = INT32_MAX, most = INT32_MIN;

    LUMI_ALWAYS_INLINE void add(int32_t v)
    {
        if (v < least) least = v;
        if (v > most) most = v;
    }
};

// The pixels that a range of places in 1/64 sample meets, of `size`, and those beside them that an outline may change.
Extent pixels_of(const Range& q6, uint32_t samples_log2, int32_t size)
{
    if (q6.least > q6.most) return {0, 0};
    const auto within = [&](int32_t v) { return v < 0 ? 0 : v < size ? v : size; };
    const uint32_t shift = 6 + samples_log2;
    return {within((q6.least >> shift) - 1), within((q6.most >> shift) + 2)};
}

void put_vertices(SurfaceFrame& frame)
{
    Range x, y;
    bool is_whole = true;
    for (uint32_t k = 0; k < frame.field.vertex_count; ++k) {
        const SamplePoint p = projected(frame.projection, view_point(frame.projection, surface_vertex(frame.field, k)));
        frame.memory.vertices[k] = packed(p, kUnlit);
        is_whole = is_whole && p.depth != 0;
        x.add(p.x_q6);
        y.add(p.y_q6);
    }
    constexpr int32_t kNarrowQ6 = 46340;  // twice a triangle's area, at most its width times its height, fits 32 bits
    frame.is_whole = is_whole;
    frame.is_narrow = x.most - x.least < kNarrowQ6 && y.most - y.least < kNarrowQ6;
    frame.columns = is_whole ? pixels_of(x, frame.samples_log2, frame.width_px) : Extent{0, frame.width_px};
    frame.scanlines = is_whole ? pixels_of(y, frame.samples_log2, frame.height_px) : Extent{0, frame.height_px};
}

void put_triangles(SurfaceFrame& frame)
{
    Lister lister(frame);
    for (uint32_t k = 0; k < frame.field.patch_count; ++k) lister.add(k, surface_patch(frame.field, k).corner);
}

// Whether a patch's nth side is an outline: nothing that faces the eye lies across.
LUMI_ALWAYS_INLINE uint32_t is_outline(const SurfaceFrame& frame, const uint8_t* neighbours, uint32_t n)
{
    const uint32_t across = static_cast<uint32_t>(neighbours[2 * n] | neighbours[2 * n + 1] << 8);
    return across == format::kNoNeighbour || frame.memory.links[across] == kTurnedAway ? 1 : 0;
}

// Bits of the sides of a patch's first triangle that are outlines, numbered as in sides.h; `other`: the second's link.
LUMI_ALWAYS_INLINE uint32_t first_outlines(const SurfaceFrame& frame, uint32_t patch, const uint8_t* neighbours,
                                           uint32_t other)
{
    const uint32_t sides = is_outline(frame, neighbours, 0) | is_outline(frame, neighbours, 1) << 1;
    if (other != kTurnedAway) return sides;
    const bool is_alone = surface_patch(frame.field, patch).corner[3] == format::kNoVertex;
    return sides | (is_alone ? is_outline(frame, neighbours, 2) : 1) << 2;
}

// The same of the second; `other`: the first's link.
LUMI_ALWAYS_INLINE uint32_t second_outlines(const SurfaceFrame& frame, const uint8_t* neighbours, uint32_t other)
{
    return is_outline(frame, neighbours, 2) | is_outline(frame, neighbours, 3) << 1 |
           (other == kTurnedAway ? 1u : 0u) << 2;
}

}  // namespace

void prepare(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode, const SurfaceMemory& memory,
             SurfaceFrame& out)
{
    out.field = field;
    out.memory = memory;
    out.width_px = camera.width_px;
    out.height_px = camera.height_px;
    out.mode = mode;
    out.samples_log2 = mode == SurfaceMode::two_by_two ? 1 : 0;
    out.margin = mode == SurfaceMode::antialiased && field.neighbours != nullptr ? 1 : 0;
    out.other_list = surface_bands(out.height_px, memory.band_log2) - 1;
    for (uint32_t k = 0; k <= out.other_list; ++k) memory.bands[k] = kEmptyBand;
    out.reach = 0;
    out.columns = out.scanlines = {0, 0};
    if (!set_projection(camera, out)) return;
    put_vertices(out);
    put_triangles(out);
}

void put_outlines(SurfaceFrame& frame)
{
    const uint16_t* link = frame.memory.links;
    const uint8_t* neighbour = frame.field.neighbours;
    uint8_t* const sides = outline_sides(frame);
    for (uint32_t patch = 0; patch < frame.field.patch_count; ++patch) {
        uint32_t bits = 0;
        if (link[0] < kWithoutSamples) bits = first_outlines(frame, patch, neighbour, link[1]);
        if (link[1] < kWithoutSamples) bits |= second_outlines(frame, neighbour, link[0]) << kSideBits;
        sides[patch] = static_cast<uint8_t>(bits);
        link += 2;
        neighbour += format::kNeighbourBytes;
    }
}

}  // namespace lumi::detail
