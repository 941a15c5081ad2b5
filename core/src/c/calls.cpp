// SPDX-License-Identifier: MIT
// The calls of lumi.h that hang on no macro: gestures, poses and packed greys.
#include "c/types.h"
#include "lumi/attitude.h"
#include "lumi/gesture.h"
#include "lumi/pack.h"

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

lumi_pose lumi_pose_of(lumi_orbit orbit)
{
    return in_c(lumi::pose_of(in_cpp(orbit)));
}

lumi_pose lumi_held_pose(lumi_quaternion turn, int32_t distance_q20)
{
    return in_c(lumi::held_pose({turn.w, turn.x, turn.y, turn.z}, distance_q20));
}

lumi_pose lumi_moved_right(lumi_pose pose, int32_t offset_q20)
{
    return in_c(lumi::moved_right(in_cpp(pose), offset_q20));
}

lumi_pose lumi_rolled(lumi_pose pose, uint32_t roll_turns32)
{
    return in_c(lumi::rolled(in_cpp(pose), roll_turns32));
}

void lumi_dither_rgb565(lumi_stripe rgb, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::dither_rgb565(in_cpp(rgb), out, out_stride_bytes);
}

void lumi_dither_rgb565_swapped(lumi_stripe rgb, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::dither_rgb565_swapped(in_cpp(rgb), out, out_stride_bytes);
}

void lumi_pack_grey4(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::pack_grey4(in_cpp(grey), out, out_stride_bytes);
}

void lumi_pack_mono1(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::pack_mono1(in_cpp(grey), out, out_stride_bytes);
}

void lumi_pack_pages(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::pack_pages(in_cpp(grey), out, out_stride_bytes);
}
