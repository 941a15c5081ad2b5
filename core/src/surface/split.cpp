// SPDX-License-Identifier: MIT
#include "surface/fill.h"

namespace lumi::detail
{
namespace
{

constexpr int32_t kWhole = 1 << CutTriangle::kWholeLog2;

Share middle(const Share& p, const Share& q)
{
    return {(p.b + q.b) / 2, (p.c + q.c) / 2};
}

// Whether the middle is one exactly.
bool can_be_halved(const Share& p, const Share& q)
{
    return ((p.b ^ q.b) & 1) == 0 && ((p.c ^ q.c) & 1) == 0;
}

class Splitter
{
public:
    Splitter(CutTriangle& cut, const SurfaceFrame& frame, const Target& target)
        : cut_(cut), frame_(frame), target_(target)
    {
    }

    bool next(Corner (&corner)[3])
    {
        while (cut_.count != 0) {
            const Cut part = cut_.pending[--cut_.count];
            if (is_ready(part, corner)) return true;
        }
        return false;
    }

private:
    // Sets the corners of a part that can be drawn as a whole, or halves it, or drops it.
    bool is_ready(const Cut& part, Corner (&corner)[3])
    {
        LUMI_TALLY(Work::split, 1);
        ViewPoint view[3];
        SamplePoint point[3];
        for (int k = 0; k < 3; ++k) {
            view[k] = view_at(part.corner[k]);
            point[k] = projected(frame_.projection, view[k]);
        }
        if (is_beside(view)) return false;
        for (int k = 0; k < 3; ++k) {
            const int next = k == 2 ? 0 : k + 1;
            if (is_whole(point[k], point[next])) continue;
            halve(part, k, next, 3 - k - next);
            return false;
        }
        LUMI_TALLY(Work::split_part, 1);
        for (int k = 0; k < 3; ++k) {
            const Share& s = part.corner[k];
            cut_.corner[k] = packed(point[k], colour(s));
            corner[k] = {&cut_.corner[k], mixed_of(s, cut_.u_q8), mixed_of(s, cut_.v_q8)};
        }
        return true;
    }

    // Whether an edge can be drawn as it is.
    bool is_whole(const SamplePoint& a, const SamplePoint& b) const
    {
        return a.depth != 0 && b.depth != 0 && magnitude(a.x_q6 - b.x_q6) < kSmallQ6 &&
               magnitude(a.y_q6 - b.y_q6) < kSmallQ6 && !is_curved(frame_, a, b);
    }

    // The other edges come first in the halves.
    void halve(const Cut& part, int from, int to, int opposite)
    {
        const Share a = part.corner[from], b = part.corner[to], c = part.corner[opposite];
        if (!can_be_halved(a, b) || cut_.count + 2 > CutTriangle::kMost) return;
        const Share m = middle(a, b);
        cut_.pending[cut_.count++] = {{m, c, a}};
        cut_.pending[cut_.count++] = {{b, c, m}};
        // Both wind as (a, b, c) does: (a, m, c) and (m, b, c), turned.
    }

    __attribute__((noinline)) static int64_t mixed(const Share& s, int64_t a, int64_t b, int64_t c)
    {
        return (a * (kWhole - s.b - s.c) + b * s.b + c * s.c) >> CutTriangle::kWholeLog2;
    }

    __attribute__((noinline)) ViewPoint view_at(const Share& s) const
    {
        const auto at = [&](int32_t ViewPoint::*k) {
            return static_cast<int32_t>(mixed(s, cut_.view[0].*k, cut_.view[1].*k, cut_.view[2].*k));
        };
        return {at(&ViewPoint::x), at(&ViewPoint::y), at(&ViewPoint::z)};
    }

    static int32_t mixed_of(const Share& s, const int32_t (&q)[3])
    {
        return static_cast<int32_t>(mixed(s, q[0], q[1], q[2]));
    }

    uint32_t colour(const Share& s) const
    {
        const SurfaceVertex* v = frame_.memory.vertices;
        const uint32_t *k = cut_.vertex, a = v[k[0]].colour, b = v[k[1]].colour, c = v[k[2]].colour;
        const auto field = [&](int32_t of_a, int32_t of_b, int32_t of_c) {
            return static_cast<uint32_t>(mixed(s, of_a, of_b, of_c)) & 0x3FF;
        };
        return field(red_q2(a), red_q2(b), red_q2(c)) << 22 | field(green_q2(a), green_q2(b), green_q2(c)) << 12 |
               field(blue_q2(a), blue_q2(b), blue_q2(c)) << 2;
    }

    // Whether all corners lie beyond one of the target's sides, or nearer than the near plane.
    __attribute__((noinline)) bool is_beside(const ViewPoint (&v)[3]) const
    {
        const SurfaceProjection& p = frame_.projection;
        const int32_t left = target_.x, right = target_.x + target_.width;
        const int32_t top = target_.y, bottom = target_.y + target_.height;
        return is_beyond(v, &ViewPoint::x, p.centre_x_q6 - 64 * left, -1) ||
               is_beyond(v, &ViewPoint::x, p.centre_x_q6 - 64 * right, 1) ||
               is_beyond(v, &ViewPoint::y, p.centre_y_q6 - 64 * top, -1) ||
               is_beyond(v, &ViewPoint::y, p.centre_y_q6 - 64 * bottom, 1) ||
               (v[0].z < p.near_z && v[1].z < p.near_z && v[2].z < p.near_z);
    }

    // Whether all places are beyond one of the target's sides, which lies `to_centre_q6` from the optical axis.
    __attribute__((noinline)) bool is_beyond(const ViewPoint (&v)[3], int32_t ViewPoint::*place, int32_t to_centre_q6,
                                             int32_t sign) const
    {
        for (const ViewPoint& at : v) {
            const int64_t beyond = place_q6(at.*place) + static_cast<int64_t>(to_centre_q6) * at.z;
            if (sign > 0 ? beyond <= 0 : beyond >= 0) return false;
        }
        return true;
    }

    // A place before the division, as 1/64 sample times z. Beyond 2^61 it stops: what it is compared with lies below
    // 2^52, and an eye far to the side of its axis may be at 2^68.
    int64_t place_q6(int32_t v) const
    {
        const int32_t left = 31 - frame_.projection.place_shift;
        if (left < 0) return int64_t{v} >> -left;
        const int64_t most = (int64_t{1} << 61) >> left;
        return (v < -most ? -most : v < most ? v : most) * (int64_t{1} << left);
    }

    CutTriangle& cut_;
    const SurfaceFrame& frame_;
    const Target& target_;
};

}  // namespace

void begin_cut(CutTriangle& cut, const SurfaceFrame& frame, uint32_t triangle)
{
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const bool is_first = (triangle & 1) == 0;
    const Places p = places_of(patch, is_first);
    const uint32_t b = patch.corner[1], c = patch.corner[2];
    cut.vertex[0] = patch.corner[is_first ? 0 : 3];
    cut.vertex[1] = is_first ? b : c;
    cut.vertex[2] = is_first ? c : b;
    cut.u_q8[0] = cut.u_q8[2] = p.u_q8;
    cut.v_q8[0] = cut.v_q8[1] = p.v_q8;
    cut.u_q8[1] = p.across_q8;
    cut.v_q8[2] = p.down_q8;
    cut.texture = texture_of(patch, frame.field);
    for (int k = 0; k < 3; ++k) cut.view[k] = view_point(frame.projection, surface_vertex(frame.field, cut.vertex[k]));
    cut.pending[0] = {{{0, 0}, {kWhole, 0}, {0, kWhole}}};
    cut.count = 1;
}

bool next_cut(CutTriangle& cut, const SurfaceFrame& frame, const Target& target, Corner (&corner)[3])
{
    return Splitter(cut, frame, target).next(corner);
}

}  // namespace lumi::detail
