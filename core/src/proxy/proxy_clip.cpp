// SPDX-License-Identifier: MIT
#include "proxy/proxy_clip.h"

namespace lumi::proxy_math
{
namespace
{

constexpr int kPlanes = 5;
constexpr int kMaxCorners = 3 + kPlanes;

struct Corner {
    int64_t x, y, z;    // as ViewPoint
    SamplePoint point;  // of an original corner, or depth 0
};

struct Polygon {
    Corner corners[kMaxCorners];
    int count;
};

// How far inside a plane a corner lies, in that plane's own unit: the near plane, then the guard band's left, right,
// upper and lower sides.
int64_t inside(const ProxyProjection& p, int plane, const Corner& c)
{
    if (plane == 0) return c.z - p.near_z;
    const bool across = plane <= 2;
    const bool positive = plane % 2 == 0;
    const int64_t centre_q6 = across ? p.centre_x_q6 : p.centre_y_q6;
    const int64_t reach_q6 = positive ? kGuardQ6 - centre_q6 : kGuardQ6 + centre_q6;
    const int64_t place = across ? c.x : c.y;
    const int up = p.depth_bits - p.place_bits + 6;  // of the place, to the format of z · reach
    const int64_t depth_reach = c.z * reach_q6 * (up < 0 ? int64_t{1} << -up : 1);
    const int64_t scaled = place * (up > 0 ? int64_t{1} << up : 1);
    return positive ? depth_reach - scaled : depth_reach + scaled;
}

// Between a corner inside and one outside a plane, from the former: the same for both triangles of an edge.
Corner cut(const Corner& in, const Corner& out, int64_t in_distance, int64_t out_distance)
{
    uint64_t part = static_cast<uint64_t>(in_distance);
    uint64_t whole = static_cast<uint64_t>(in_distance) + static_cast<uint64_t>(-out_distance);
    while (whole >> 33 != 0) {
        whole >>= 1;
        part >>= 1;
    }
    const int64_t share_q30 = static_cast<int64_t>((part << 30) / whole);
    const auto between = [&](int64_t a, int64_t b) { return a + ((b - a) * share_q30 >> 30); };
    return {between(in.x, out.x), between(in.y, out.y), between(in.z, out.z), {0, 0, 0}};
}

// Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
void clip(const ProxyProjection& p, int plane, const Polygon& from, Polygon& to)
{
    to.count = 0;
    for (int k = 0; k < from.count; ++k) {
        const Corner& here = from.corners[k];
        const Corner& next = from.corners[k + 1 < from.count ? k + 1 : 0];
        const int64_t d = inside(p, plane, here), d_next = inside(p, plane, next);
        if (d >= 0) to.corners[to.count++] = here;
        if (d >= 0 && d_next < 0) to.corners[to.count++] = cut(here, next, d, d_next);
        if (d < 0 && d_next >= 0) to.corners[to.count++] = cut(next, here, d_next, d);
    }
}

int64_t rounded_ratio(int64_t over, int64_t under)
{
    return (over < 0 ? over - under / 2 : over + under / 2) / under;
}

int32_t limited(int64_t v_q6)
{
    return static_cast<int32_t>(v_q6 < -kGuardQ6 ? -kGuardQ6 : v_q6 > kGuardQ6 ? kGuardQ6 : v_q6);
}

SamplePoint place(const ProxyProjection& p, const Corner& c)
{
    if (c.point.depth != 0) return c.point;
    const int64_t z = c.z > p.near_z ? c.z : p.near_z;
    const int up = p.depth_bits - p.place_bits + 6;
    const auto q6 = [&](int64_t v) {
        return up >= 0 ? rounded_ratio(v * (int64_t{1} << up), z) : rounded_ratio(v, z << -up);
    };
    // near · range · (far - z) / ((far - near) · z)
    const int64_t ahead = p.far_z > z ? p.far_z - z : 0;
    const int64_t share_q31 = (ahead << 31) / (p.far_z - p.near_z);
    const int64_t range = (share_q31 * (kNearDepth - kFarDepth)) >> 16;
    const int64_t depth = range * p.near_z / z >> 15;
    return {limited(q6(c.x) + p.centre_x_q6), limited(q6(c.y) + p.centre_y_q6),
            static_cast<int32_t>(kFarDepth + depth)};
}

Corner corner(const ProxyFrame& frame, uint32_t vertex)
{
    const ViewPoint v = view_point(frame.projection, triple12(frame.mesh.vertices, vertex));
    return {v.x, v.y, v.z, project(frame.projection, v)};
}

}  // namespace

void fill_clipped(const ProxyFrame& frame, const Triple12& triangle, const DepthTarget& target)
{
    Polygon polygons[2];
    polygons[0] = {{corner(frame, triangle.a), corner(frame, triangle.b), corner(frame, triangle.c)}, 3};
    for (int plane = 0; plane < kPlanes; ++plane) {
        clip(frame.projection, plane, polygons[plane & 1], polygons[~plane & 1]);
    }
    const Polygon& rest = polygons[kPlanes & 1];
    if (rest.count < 3) return;
    const SamplePoint first = place(frame.projection, rest.corners[0]);
    SamplePoint before = place(frame.projection, rest.corners[1]);
    for (int k = 2; k < rest.count; ++k) {
        const SamplePoint here = place(frame.projection, rest.corners[k]);
        const bool outside = wide_doubled_area(first, before, here) < 0;  // seen counter-clockwise
        if (outside || frame.mesh.two_sided) fill_triangle(packed(first), packed(before), packed(here), target);
        before = here;
    }
}

}  // namespace lumi::proxy_math
