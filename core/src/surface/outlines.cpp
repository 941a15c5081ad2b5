// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/resolve.h"
#include "surface/box.h"
#include "surface/lists.h"
#include "surface/sides.h"
#include "surface/silhouette.h"

namespace lumi::detail
{
namespace
{

void mark_sides(const SurfaceFrame& frame, uint32_t k, uint32_t sides, const Target& target)
{
    const SurfacePatch patch = surface_patch(frame.field, k >> 1);
    const SurfaceVertex* v = frame.memory.vertices;
    const uint32_t odd = k & 1;
    if (!reaches({&v[patch.corner[3 * odd]], &v[patch.corner[1]], &v[patch.corner[2]]}, target)) return;
    for (uint32_t m = 0; sides != 0; ++m, sides >>= 1) {
        if ((sides & 1) == 0) continue;
        const Side side = side_of(patch, k, m);
        if (is_there(v[side.from]) && is_there(v[side.to])) mark_edge(v[side.from], v[side.to], target);
    }
}

}  // namespace

LUMI_HOT void mark_outlines(const SurfaceFrame& frame, const Target& target)
{
    const auto mark = [&](uint32_t triangle) {
        if (const uint32_t sides = outline_sides_of(frame, triangle); sides != 0)
            mark_sides(frame, triangle, sides, target);
    };
    ListWalk walk = walk_of(frame, target);
    for (uint32_t triangle = 0; next_listed(walk, frame, triangle);) mark(triangle);
    for (uint32_t other = frame.memory.bands[frame.other_list]; other != kEmptyBand;) {
        mark(other);
        other = after(other, frame.memory.links[other]);
    }
}

}  // namespace lumi::detail
