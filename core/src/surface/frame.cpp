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

class Lister
{
public:
    explicit Lister(SurfaceFrame& frame)
        : frame_(frame),
          scanlines_(frame.height_px << frame.samples_log2),
          right_q6_(frame.width_px << (frame.samples_log2 + 6)),
          band_log2_(frame.samples_log2 + frame.memory.band_log2)
    {
    }

    // The triangles (a, b, c) and (d, c, b) of a patch.
    LUMI_ALWAYS_INLINE void add(uint32_t patch, const uint32_t (&corner)[4])
    {
        const SurfaceVertex* v = frame_.memory.vertices;
        const SurfaceVertex &b = v[corner[1]], &c = v[corner[2]];
        const int32_t x = x_q6(b), y = y_q6(b), across = x_q6(c) - x, down = y_q6(c) - y;
        const auto area_with = [&](const SurfaceVertex& other) {
            const int32_t right = x_q6(other) - x, below = y_q6(other) - y;
            return frame_.is_narrow ? across * below - right * down : wide_sign(across, below, right, down);
        };
        add(2 * patch, area_with(v[corner[0]]), {&v[corner[0]], &b, &c});
        if (corner[3] != format::kNoVertex)
            add(2 * patch + 1, -area_with(v[corner[3]]), {&v[corner[3]], &c, &b});
        else
            frame_.memory.links[2 * patch + 1] = kTurnedAway;
    }

private:
    LUMI_ALWAYS_INLINE void add(uint32_t triangle, int32_t area, const Seen& s)
    {
        if (!frame_.is_whole && !s.are_there())
            put(frame_, frame_.other_list, triangle, 0);
        else if (area >= 0)
            return void(frame_.memory.links[triangle] = kTurnedAway);
        else if (!list(triangle, s))
            return void(frame_.memory.links[triangle] = kWithoutSamples);
        light(frame_, s.a);
        light(frame_, s.b);
        light(frame_, s.c);
    }

    // False if it lies beside the image or between the scanlines.
    __attribute__((noinline)) bool list(uint32_t triangle, const Seen& s)
    {
        const int32_t upper_q6 = s.upper_q6(), lower_q6 = s.lower_q6(), left_q6 = s.left_q6(), right_q6 = s.right_q6();
        const int32_t first = line_from(upper_q6), last = line_from(lower_q6);
        const int32_t begin = first > 0 ? first : 0, end = last < scanlines_ ? last : scanlines_;
        if (begin >= end || right_q6 < 0 || left_q6 > right_q6_) return false;
        const bool is_small = lower_q6 - upper_q6 < kSmallQ6 && right_q6 - left_q6 < kSmallQ6;
        const uint32_t band = static_cast<uint32_t>(begin + frame_.margin) >> band_log2_;
        const uint32_t last_band = static_cast<uint32_t>(end - 1 + frame_.margin) >> band_log2_;
        const int32_t reach = static_cast<int32_t>(last_band - band);
        const bool is_listed = is_small && reach < kBandReach &&
                               (frame_.projection.curved_from == UINT32_MAX || !has_curved_edge(frame_, s));
        const uint32_t nearness = static_cast<uint32_t>(s.a->y & 0xFF) * kBandLists >> 8;
        if (is_listed && reach > frame_.reach) frame_.reach = reach;
        put(frame_, is_listed ? list_of(band, nearness) : frame_.other_list, triangle, is_listed ? reach : 0);
        return true;
    }

    SurfaceFrame& frame_;
    const int32_t scanlines_, right_q6_;
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
    for (uint32_t k = 0; k < frame.field.patch_count; ++k) {
        const SurfacePatch patch = surface_patch(frame.field, k);
        lister.add(k, patch.corner);
    }
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
    uint16_t* const bits = outline_bits(frame);
    for (uint32_t triangle = 0; triangle < 2 * frame.field.patch_count; ++triangle) {
        if ((triangle & 3) == 0) bits[triangle >> 2] = 0;
        if (frame.memory.links[triangle] >= kWithoutSamples) continue;
        const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
        uint32_t sides = 0;
        for (uint32_t k = 0; k < 3; ++k)
            if (is_outline(frame, side_of(frame.field, patch, triangle, k))) sides |= 1u << k;
        bits[triangle >> 2] = static_cast<uint16_t>(bits[triangle >> 2] | sides << (4 * (triangle & 3)));
    }
}

}  // namespace lumi::detail
