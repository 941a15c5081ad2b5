// SPDX-License-Identifier: MIT
// A frame's vertices and lists of triangles.
#include "lumi/proxy/proxy_frame.h"

#include "proxy/proxy_bands.h"
#include "proxy/proxy_points.h"
#include "proxy/proxy_projection.h"

namespace lumi
{
namespace
{

using namespace proxy_math;

static_assert(format::kMaxProxyTriangles <= kLinkMask + 1, "a link holds every triangle's number");
static_assert(kBandReach <= 1 << (16 - kLinkBits), "and how far it reaches");

// The image on the sample grid.
struct Extent {
    int32_t rows, right_q6;
    bool is_whole;  // no vertex is missing
};

// Whether the outside of a triangle is seen, or any side of a two-sided mesh. Not of triangles seen edge-on.
LUMI_ALWAYS_INLINE bool is_seen(const ProxyFrame& frame, const Corners& c)
{
    if (frame.narrow) {
        const int32_t area = doubled_area(unpacked(*c.a), unpacked(*c.b), unpacked(*c.c));
        return area < 0 || (area > 0 && frame.mesh.two_sided);
    }
    const int64_t area = wide_doubled_area(unpacked(*c.a), unpacked(*c.b), unpacked(*c.c));
    return area < 0 || (area > 0 && frame.mesh.two_sided);
}

// Puts triangle k before the others of a list.
void put(ProxyFrame& frame, uint32_t list, uint32_t k, int32_t reach)
{
    uint16_t& first = frame.memory.bands[list];
    const uint32_t next = first == kEmptyBand ? k : first;
    frame.memory.links[k] = static_cast<uint16_t>(next | static_cast<uint32_t>(reach) << kLinkBits);
    first = static_cast<uint16_t>(k);
}

// Lists a triangle by its rows of samples [begin, end) of the image.
void put_by_rows(ProxyFrame& frame, uint32_t k, int32_t begin, int32_t end)
{
    uint32_t list = 0, log2 = frame.memory.band_log2;
    const int32_t first_row = begin >> frame.samples_log2, last_row = (end - 1) >> frame.samples_log2;
    for (uint32_t level = 0; level < kBandLevels; ++level, log2 += kBandLevelLog2) {
        const int32_t first = first_row >> log2, reach = (last_row >> log2) - first;
        if (reach < kBandReach) return put(frame, list + static_cast<uint32_t>(first), k, reach);
        list += proxy_bands_of_level(frame.height_px, log2);
    }
    put(frame, frame.clipped_band, k, 0);
}

LUMI_ALWAYS_INLINE void put_triangle(ProxyFrame& frame, uint32_t k, const Extent& extent)
{
    ProxyVertex room[3];
    const Corners c = corners_of(frame, triple12(frame.mesh.triangles, k), room);
    if (!extent.is_whole && !c.are_all_there()) return put(frame, frame.clipped_band, k, 0);
    if (!is_seen(frame, c)) return;
    // Packed numbers compare as their upper bits do.
    const int32_t upper_q6 = least_of(c.a->y, c.b->y, c.c->y) >> 8, lower_q6 = most_of(c.a->y, c.b->y, c.c->y) >> 8;
    const int32_t left_q6 = least_of(c.a->x, c.b->x, c.c->x) >> 8, right_q6 = most_of(c.a->x, c.b->x, c.c->x) >> 8;
    const int32_t first = row_from(upper_q6), last = row_from(lower_q6);
    const int32_t begin = first > 0 ? first : 0, end = last < extent.rows ? last : extent.rows;
    if (begin >= end || right_q6 < 0 || left_q6 > extent.right_q6) return;
    if (lower_q6 - upper_q6 >= kSmallQ6 || right_q6 - left_q6 >= kSmallQ6) return put(frame, frame.clipped_band, k, 0);
    put_by_rows(frame, k, begin, end);
}

void put_triangles(ProxyFrame& frame, bool is_whole)
{
    for (uint32_t k = 0; k <= frame.clipped_band; ++k) frame.memory.bands[k] = kEmptyBand;
    const Extent extent = {frame.height_px << frame.samples_log2, frame.width_px << (frame.samples_log2 + 6), is_whole};
    for (uint32_t k = 0; k < frame.mesh.triangle_count; ++k) put_triangle(frame, k, extent);
}

struct Range {
    int32_t least = INT32_MAX, most = INT32_MIN;

    LUMI_ALWAYS_INLINE void add(int32_t v)
    {
        if (v < least) least = v;
        if (v > most) most = v;
    }
    // Twice a triangle's area is at most its width times its height.
    bool is_narrow() const { return most < least || most - least < 46340; }
};

// Projects the vertices, once, and keeps them where there is memory. Returns whether all of them are there.
bool put_vertices(ProxyFrame& frame)
{
    Range x, y;
    bool is_whole = true;
    const ProxyMesh mesh = frame.mesh;
    ProxyVertex* const vertices = frame.memory.vertices;
    for (uint32_t k = 0; k < mesh.vertex_count; ++k) {
        const SamplePoint p = projected(frame.projection, triple12(mesh.vertices, k));
        if (vertices != nullptr) vertices[k] = packed(p);
        if (p.depth == 0) {
            is_whole = false;
            continue;
        }
        x.add(p.x_q6);
        y.add(p.y_q6);
    }
    frame.narrow = x.is_narrow() && y.is_narrow();
    return is_whole;
}

}  // namespace

void prepare_proxy(const ProxyMesh& mesh, const GuidedCamera& camera, uint32_t samples, const ProxyMemory& memory,
                   ProxyFrame& out)
{
    out.mesh = mesh;
    out.memory = memory;
    out.width_px = camera.camera.width_px();
    out.height_px = camera.camera.height_px();
    out.samples_log2 = samples > 1 ? 1 : 0;
    out.clipped_band = proxy_bands(out.height_px, memory.band_log2) - 1;
    if (!set_projection(mesh, camera, out)) out.mesh.triangle_count = 0;
    const bool is_whole = out.mesh.triangle_count == 0 || put_vertices(out);
    put_triangles(out, is_whole);
}

}  // namespace lumi
