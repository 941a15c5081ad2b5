// SPDX-License-Identifier: MIT
#include "lumi/surface/render.h"
#include "surface/bands.h"
#include "surface/sides.h"
#include "surface/silhouette.h"
#include "surface/split.h"

namespace lumi::detail
{
namespace
{

MeshTriangle mesh_triangle(const SurfacePatch& patch, const SurfaceField& field, uint32_t k)
{
    constexpr int32_t kInsetQ8 = 256 >> format::kPatchInsetShift;
    const int32_t right = static_cast<int32_t>(patch.columns << 8) - kInsetQ8;
    const int32_t bottom = static_cast<int32_t>(patch.rows << 8) - kInsetQ8;
    const Texture texture = {field.texels + patch.texels, patch.columns, patch.rows};
    const uint32_t* corner = patch.corner;
    if ((k & 1) == 0)
        return {{corner[0], corner[1], corner[2]}, {kInsetQ8, right, kInsetQ8}, {kInsetQ8, kInsetQ8, bottom}, texture};
    return {{corner[3], corner[2], corner[1]}, {right, kInsetQ8, right}, {bottom, bottom, kInsetQ8}, texture};
}

// Whether a listed triangle has samples in the target's scanlines. Packed numbers compare as their upper bits do.
LUMI_ALWAYS_INLINE bool reaches(const SurfaceFrame& frame, const SurfacePatch& patch, uint32_t k, const Target& target)
{
    const SurfaceVertex* v = frame.memory.vertices;
    const int32_t top = target.y << 14, bottom = (target.y + target.height) << 14;
    const int32_t a = v[patch.corner[3 * (k & 1)]].y, b = v[patch.corner[1]].y, c = v[patch.corner[2]].y;
    return (a > top || b > top || c > top) && (a < bottom || b < bottom || c < bottom);
}

void fill_listed(const SurfaceFrame& frame, uint32_t k, const Target& target)
{
    const SurfacePatch patch = surface_patch(frame.field, k >> 1);
    if (!reaches(frame, patch, k, target)) return;
    const MeshTriangle t = mesh_triangle(patch, frame.field, k);
    const auto corner = [&](int m) {
        const SurfaceVertex& v = frame.memory.vertices[t.vertex[m]];
        return Corner{unpacked(v), t.u_q8[m], t.v_q8[m], v.colour};
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

void mark_sides(const SurfaceFrame& frame, uint32_t k, const Target& target)
{
    const SurfacePatch patch = surface_patch(frame.field, k >> 1);
    if (!reaches(frame, patch, k, target)) return;
    const SurfaceVertex* v = frame.memory.vertices;
    for (const Side& side : sides_of(frame.field, patch, k).side) {
        const SurfaceVertex &from = v[side.from], &to = v[side.to];
        if (is_outline(frame, side) && is_there(from) && is_there(to)) mark_edge(from, to, target);
    }
}

// Calls draw(triangle) for each that may reach scanlines [top, bottom), of the bands and of the other list.
template <class Draw, class DrawOther>
void each_between(const SurfaceFrame& frame, int32_t top, int32_t bottom, const Draw& draw, const DrawOther& draw_other)
{
    const int32_t first = top >> frame.memory.band_log2, last = (bottom - 1) >> frame.memory.band_log2;
    for (int32_t band = first < kBandReach ? 0 : first - kBandReach + 1; band <= last; ++band) {
        each_of(
            frame, static_cast<uint32_t>(band),
            [&](uint32_t k, int32_t reach) {
                if (band + reach >= first) draw(k);
            });
    }
    each_of(frame, frame.other_list, [&](uint32_t k, int32_t) { draw_other(k); });
}

}  // namespace

LUMI_HOT void rasterize(const SurfaceFrame& frame, const SampleRect& rect, uint16_t* depths, PackedColour* colours)
{
    const int32_t log2 = static_cast<int32_t>(frame.samples_log2);
    const Target target = {depths,
                           colours,
                           rect.x_px << log2,
                           rect.y_px << log2,
                           rect.width_px << log2,
                           rect.height_px << log2,
                           frame.palette,
                           frame.mode == SurfaceMode::antialiased,
                           frame.mode == SurfaceMode::one_sample ? -1 : 512 >> log2};
    const uint32_t samples = static_cast<uint32_t>(target.width) * static_cast<uint32_t>(target.height);
    __builtin_memset(depths, 0, samples * sizeof *depths);
    const int32_t bottom_px = rect.y_px + rect.height_px;
    each_between(
        frame, rect.y_px, bottom_px, [&](uint32_t k) { fill_listed(frame, k, target); },
        [&](uint32_t k) {
            fill_in_parts(frame, mesh_triangle(surface_patch(frame.field, k >> 1), frame.field, k), target);
        });
    if (!blends_outlines(frame)) return;
    const auto mark = [&](uint32_t k) {
        if (has_outline(frame, k)) mark_sides(frame, k, target);
    };
    each_between(frame, rect.y_px, bottom_px, mark, mark);
}

}  // namespace lumi::detail
