// SPDX-License-Identifier: MIT
#include "lumi/render_surface.h"
#include "surface/bands.h"
#include "surface/silhouette.h"
#include "surface/split.h"

namespace lumi::surfaces
{
namespace
{

MeshTriangle mesh_triangle(const SurfaceField& field, uint32_t k)
{
    const SurfacePatch patch = surface_patch(field, k >> 1);
    constexpr int32_t kInsetQ8 = 256 >> format::kPatchInsetShift;
    const int32_t right = static_cast<int32_t>(patch.columns << 8) - kInsetQ8;
    const int32_t bottom = static_cast<int32_t>(patch.rows << 8) - kInsetQ8;
    const Texture texture = {field.texels + patch.texels, patch.columns};
    const uint32_t* corner = patch.corner;
    if ((k & 1) == 0) {
        return {{corner[0], corner[1], corner[2]}, {kInsetQ8, right, kInsetQ8}, {kInsetQ8, kInsetQ8, bottom}, texture};
    }
    return {{corner[3], corner[2], corner[1]}, {right, kInsetQ8, right}, {bottom, bottom, kInsetQ8}, texture};
}

void fill_listed(const SurfaceFrame& frame, uint32_t k, const Target& target)
{
    const MeshTriangle t = mesh_triangle(frame.field, k);
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

// Of a triangle's sides the vertices, and the triangle across.
struct Side {
    uint32_t from, to, neighbour;
};

void mark_sides(const SurfaceFrame& frame, uint32_t k, const Target& target)
{
    const SurfacePatch patch = surface_patch(frame.field, k >> 1);
    const uint8_t* p = frame.field.neighbours + (k >> 1) * format::kNeighbourBytes;
    const auto neighbour = [&](int at) { return static_cast<uint32_t>(p[2 * at] | p[2 * at + 1] << 8); };
    const uint32_t *v = patch.corner, other = k ^ 1;
    const bool is_lone = v[3] == format::kNoVertex;
    const Side sides[] = {k & 1 ? Side{v[3], v[2], neighbour(2)} : Side{v[0], v[1], neighbour(0)},
                          k & 1 ? Side{v[1], v[3], neighbour(3)} : Side{v[2], v[0], neighbour(1)},
                          k & 1 ? Side{v[2], v[1], other} : Side{v[1], v[2], is_lone ? neighbour(2) : other}};
    for (const Side& side : sides) {
        const bool is_outline =
            side.neighbour == format::kNoNeighbour || frame.memory.links[side.neighbour] == kUnlisted;
        const SurfaceVertex &from = frame.memory.vertices[side.from], &to = frame.memory.vertices[side.to];
        if (is_outline && is_there(from) && is_there(to)) {
            mark_edge(from, to, frame.projection.one_surface, target);
        }
    }
}

// Calls draw(triangle) for each that may reach rows of pixels [top, bottom), of the bands and of the other list.
template <class Draw, class DrawOther>
void each_between(const SurfaceFrame& frame, int32_t top, int32_t bottom, const Draw& draw, const DrawOther& draw_other)
{
    const int32_t first = top >> frame.memory.band_log2, last = (bottom - 1) >> frame.memory.band_log2;
    for (int32_t band = first < kBandReach ? 0 : first - kBandReach + 1; band <= last; ++band) {
        each_of(frame, static_cast<uint32_t>(band), [&](uint32_t k, int32_t reach) {
            if (band + reach >= first) draw(k);
        });
    }
    each_of(frame, frame.other_list, [&](uint32_t k, int32_t) { draw_other(k); });
}

}  // namespace

void rasterize(const SurfaceFrame& frame, const SampleRect& rect, uint16_t* depths, PackedColour* colours)
{
    const int32_t log2 = static_cast<int32_t>(frame.samples_log2);
    const Target target = {depths,
                           colours,
                           rect.x_px << log2,
                           rect.y_px << log2,
                           rect.width_px << log2,
                           rect.height_px << log2,
                           frame.palette,
                           frame.mode == SurfaceMode::antialiased};
    const uint32_t samples = static_cast<uint32_t>(target.width) * static_cast<uint32_t>(target.height);
    __builtin_memset(depths, 0, samples * sizeof *depths);
    const int32_t bottom_px = rect.y_px + rect.height_px;
    each_between(
        frame, rect.y_px, bottom_px, [&](uint32_t k) { fill_listed(frame, k, target); },
        [&](uint32_t k) { fill_in_parts(frame, mesh_triangle(frame.field, k), target); });
    if (!blends_outlines(frame)) return;
    const auto mark = [&](uint32_t k) { mark_sides(frame, k, target); };
    each_between(frame, rect.y_px, bottom_px, mark, mark);
}

}  // namespace lumi::surfaces
