// SPDX-License-Identifier: MIT
#include "lumi/render_surface.h"
#include "surface/bands.h"
#include "surface/split.h"

namespace lumi::surfaces
{
namespace
{

MeshTriangle mesh_triangle(const SurfaceField& field, uint32_t k)
{
    const SurfacePatch patch = surface_patch(field, k >> 1);
    constexpr int32_t kInsetQ10 = 1024 >> format::kPatchInsetShift;
    const int32_t right = static_cast<int32_t>(patch.columns << 10) - kInsetQ10;
    const int32_t bottom = static_cast<int32_t>(patch.rows << 10) - kInsetQ10;
    const Texture texture = {field.texels + patch.texels, patch.columns};
    const uint32_t* corner = patch.corner;
    if ((k & 1) == 0) {
        return {
            {corner[0], corner[1], corner[2]}, {kInsetQ10, right, kInsetQ10}, {kInsetQ10, kInsetQ10, bottom}, texture};
    }
    return {{corner[3], corner[2], corner[1]}, {right, kInsetQ10, right}, {bottom, bottom, kInsetQ10}, texture};
}

void fill_listed(const SurfaceFrame& frame, uint32_t k, const Target& target)
{
    const MeshTriangle t = mesh_triangle(frame.field, k);
    const auto corner = [&](int m) {
        const SurfaceVertex& v = frame.memory.vertices[t.vertex[m]];
        return Corner{unpacked(v), t.u_q10[m], t.v_q10[m], v.colour};
    };
    fill_triangle(corner(0), corner(1), corner(2), frame.field.two_sided, t.texture, target);
}

// Calls draw(triangle, reach) for each of a list.
template <class Draw>
void each_of(const SurfaceFrame& frame, uint32_t list, const Draw& draw)
{
    uint32_t k = frame.memory.bands[list];
    if (k == kEmptyBand) return;
    while (true) {
        const uint32_t link = frame.memory.links[k];
        draw(k, static_cast<int32_t>(link >> kLinkBits));
        if ((link & kLinkMask) == k) return;
        k = link & kLinkMask;
    }
}

}  // namespace

void rasterize(const SurfaceFrame& frame, const SampleRect& rect, uint16_t* depths, PackedColour* colours)
{
    const int32_t log2 = static_cast<int32_t>(frame.samples_log2);
    const Target target = {
        depths,       colours, rect.x_px << log2, rect.y_px << log2, rect.width_px << log2, rect.height_px << log2,
        frame.palette};
    const uint32_t samples = static_cast<uint32_t>(target.width) * static_cast<uint32_t>(target.height);
    __builtin_memset(depths, 0, samples * sizeof *depths);
    const int32_t first = rect.y_px >> frame.memory.band_log2;
    const int32_t last = (rect.y_px + rect.height_px - 1) >> frame.memory.band_log2;
    for (int32_t band = first < kBandReach ? 0 : first - kBandReach + 1; band <= last; ++band) {
        each_of(frame, static_cast<uint32_t>(band), [&](uint32_t k, int32_t reach) {
            if (band + reach >= first) fill_listed(frame, k, target);
        });
    }
    each_of(frame, frame.other_list,
            [&](uint32_t k, int32_t) { fill_in_parts(frame, mesh_triangle(frame.field, k), target); });
}

}  // namespace lumi::surfaces
