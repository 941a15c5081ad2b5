// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/gloss.h"
#include "surface/fill.h"
#include "surface/lists.h"
#include "surface/moving.h"
#include "surface/planes.h"

namespace lumi::detail
{
namespace
{

// Returns the place at a part of the way between two.
int32_t part_between(int32_t from, int32_t to, int32_t part, int32_t whole)
{
    return (to - from) * part / whole;
}

// Clamps a place into the disc so far that its reads lie there, too: a sample reads half a texel around it, steps over
// a triangle lose half a texel at most (a quarter by their fractions, 0.15 by shares of corners, 0.1 by samples just
// outside).
int32_t within_disc(int32_t place_q8)
{
    constexpr int32_t kLeast = 5 * 64, kMost = static_cast<int32_t>(kGlossDiscSide) * 256 - kLeast;
    return place_q8 < kLeast ? kLeast : place_q8 < kMost ? place_q8 : kMost;
}

}  // namespace

LUMI_ALWAYS_INLINE bool GlossPieces::next_whole()
{
    if (piece.is_wide && next_part_of_wide(piece)) {
        gloss.place = first_place_ + static_cast<uint32_t>(piece.wide.at) * gloss.down;
        return true;
    }
    for (uint32_t triangle = 0; next_listed(walk_, frame_, triangle);) {
        if (!begin_whole(piece, frame_, triangle, target_)) continue;
        begin_whole_gloss(triangle);
        return true;
    }
    return false;
}

template <class Place>
LUMI_ALWAYS_INLINE bool GlossPieces::next_cut_of(const Place& place)
{
    while (true) {
        if (next_of_cut()) return true;
        if (other_ == kEmptyBand) return false;
        begin_cut(cut_, frame_, other_);
        place(cut_);
        choose(other_ >> 1);
        other_ = after(other_, frame_.memory.links[other_]);
    }
}

LUMI_HOT bool GlossPieces::next()
{
    return next_whole() || next_cut();
}

bool MovingGlossPieces::next()
{
    return next_whole() || next_cut();
}

__attribute__((noinline)) bool GlossPieces::next_cut()
{
    return next_cut_of([](CutTriangle&) {});
}

__attribute__((noinline)) bool MovingGlossPieces::next_cut()
{
    return next_cut_of([&](CutTriangle& cut) { place_cut(frame_, cut); });
}

bool GlossPieces::next_of_cut()
{
    Corner corner[3];
    while (lumi::detail::next_cut(cut_, frame_, target_, corner)) {
        TriangleSize size;
        Extent columns;
        if (!set_size(size, columns, {corner[0].at, corner[1].at, corner[2].at}, target_) ||
            !begin_triangle(piece, corner, size, cut_.texture, target_))
            continue;
        if (gloss.disc != nullptr) begin_cut_gloss(corner);
        return true;
    }
    return false;
}

bool GlossPieces::choose(uint32_t patch)
{
    const uint32_t map = gloss_of(frame_.field, patch);
    gloss.disc = map == 0 ? nullptr : memory_.discs + (map - 1) * kGlossDiscBytes;
    gloss.colours = memory_.colours + (map == 0 ? 0 : map - 1) * kGlossColours;
    return map != 0;
}

Corner GlossPieces::in_disc(const SurfaceVertex* at, uint32_t place) const
{
    return {at, within_disc(static_cast<int32_t>(place & 0xFF) * 64),
            within_disc(static_cast<int32_t>(place >> 8) * 64)};
}

void GlossPieces::begin_whole_gloss(uint32_t triangle)
{
    if (!choose(triangle >> 1)) return;
    const SurfacePatch patch = surface_patch(frame_.field, triangle >> 1);
    const bool is_first = (triangle & 1) == 0;
    const uint32_t vertex[3] = {patch.corner[is_first ? 0 : 3], patch.corner[is_first ? 1 : 2],
                                patch.corner[is_first ? 2 : 1]};
    Corner corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = in_disc(frame_.memory.vertices + vertex[k], memory_.places[vertex[k]]);
    begin_gloss(corner);
}

// Its shares of the whole triangle's corners are those of its place in the texture, whose sides are those of the first
// corner.
void GlossPieces::begin_cut_gloss(const Corner (&corner)[3])
{
    const int32_t *u = cut_.u_q8, *v = cut_.v_q8;
    Corner whole[3], part[3];
    for (int k = 0; k < 3; ++k) whole[k] = in_disc(nullptr, memory_.places[cut_.vertex[k]]);
    for (int k = 0; k < 3; ++k) {
        const int32_t to_b = corner[k].u_q8 - u[0], to_c = corner[k].v_q8 - v[0];
        const auto mixed = [&](int32_t Corner::*place) {
            return whole[0].*place + part_between(whole[0].*place, whole[1].*place, to_b, u[1] - u[0]) +
                   part_between(whole[0].*place, whole[2].*place, to_c, v[2] - v[0]);
        };
        part[k] = {corner[k].at, within_disc(mixed(&Corner::u_q8)), within_disc(mixed(&Corner::v_q8))};
    }
    begin_gloss(part);
}

void GlossPieces::begin_gloss(const Corner (&corner)[3])
{
    LUMI_TALLY(Work::gloss_begun, 1);
    const Seen s = {corner[0].at, corner[1].at, corner[2].at};
    Facing f = {&corner[0], &corner[1], &corner[2], between(*s.a, *s.b), between(*s.a, *s.c)};
    const int32_t wide_q6 = (s.right() >> 8) - (s.left() >> 8), high_q6 = (s.lower() >> 8) - (s.upper() >> 8);
    const auto area = static_cast<uint32_t>(-doubled_area(f.ab, f.ac));
    const Shares shares = shares_of(f, area, wide_q6 > high_q6 ? wide_q6 : high_q6);
    const int32_t first = line_from(s.upper() >> 8);
    const Plane place = PlaneMaker(f, shares, target_.x, first > target_.y ? first : target_.y).place();
    gloss.place = first_place_ = place.value;
    gloss.right = place.right;
    gloss.down = place.down;
}

}  // namespace lumi::detail
