// SPDX-License-Identifier: MIT
#include "lumi/surface/detail/see_through.h"
#include "surface/box.h"
#include "surface/cut_pixels.h"
#include "surface/see_through/order.h"
#include "surface/sides.h"

namespace lumi::detail
{
namespace
{

void mark_sides(const SurfaceFrame& frame, uint32_t triangle, const Target& target)
{
    const Seen s = seen(frame, triangle);
    if (!reaches(s, target)) return;
    const SurfacePatch patch = surface_patch(frame.field, triangle >> 1);
    const SurfaceVertex* const v = frame.memory.vertices;
    for (uint32_t n = 0; n < 3; ++n) {
        const Side side = side_of(patch, triangle, n);
        if (is_there(v[side.from]) && is_there(v[side.to]) && is_outline(frame, patch, triangle, n))
            mark_cut_pixels<true>(v[side.from], v[side.to], target);
    }
}

}  // namespace

LUMI_HOT void mark_see_through_outlines(const SeeThroughFrame& frame, const Target& target)
{
    for (uint32_t k = 0; k < frame.order_count; ++k)
        if ((frame.order[k] & kHasOutline) != 0) mark_sides(frame, triangle_of(frame.order[k]), target);
}

}  // namespace lumi::detail
