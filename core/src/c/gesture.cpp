// SPDX-License-Identifier: MIT
#include "lumi/gesture.h"

#include "c/types.h"

using namespace lumi::detail;

namespace
{

// A lumi_drag holds this.
struct Drag : lumi::OrbitDrag {
    using OrbitDrag::OrbitDrag;

    static void* operator new(size_t, void* memory) { return memory; }  // <new> is not everywhere
};
static_assert(sizeof(Drag) <= sizeof(lumi_drag) && alignof(Drag) <= alignof(lumi_drag), "a lumi_drag holds it");

}  // namespace

void lumi_drag_start(lumi_drag* drag, lumi_drag_settings settings)
{
    new (drag) Drag({settings.turns32_per_px, settings.half_life_ms, settings.elevation_limit});
}

bool lumi_drag_next(lumi_drag* drag, lumi_touch touch, uint32_t elapsed_ms, lumi_orbit* orbit)
{
    lumi::Orbit next = in_cpp(*orbit);
    const bool moves = reinterpret_cast<Drag*>(drag)->next({touch.is_down, touch.x_px, touch.y_px}, elapsed_ms, next);
    orbit->azimuth_turns32 = next.azimuth_turns32;
    orbit->elevation_turns32 = next.elevation_turns32;
    return moves;
}
