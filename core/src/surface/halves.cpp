// SPDX-License-Identifier: MIT
#include "lumi/surface/halves.h"

#include "surface/moving.h"

namespace lumi::detail
{
namespace
{

// A vertex's colour from when a triangle of its is listed until it is lit.
constexpr uint32_t kWanted = 2;

// Both cores may want one vertex at once: they write the same.
void want_light(const SurfaceFrame& frame, const SurfaceVertex* v)
{
    if (__atomic_load_n(&v->colour, __ATOMIC_RELAXED) != kUnlit) return;
    const uint32_t vertex = static_cast<uint32_t>(v - frame.memory.vertices);
    __atomic_store_n(&frame.memory.vertices[vertex].colour, kWanted, __ATOMIC_RELAXED);
}

// A half that does not run may have left vertices anywhere.
constexpr PlaceRange kAnyPlace = {-kGuardQ6, kGuardQ6};
constexpr PlacedVertices kNotPlaced = {kAnyPlace, kAnyPlace, false};

PlaceRange joined(const PlaceRange& a, const PlaceRange& b)
{
    return {a.least < b.least ? a.least : b.least, a.most > b.most ? a.most : b.most};
}

void place_half(SurfaceHalves& halves, uint32_t half)
{
    const SurfaceFrame& frame = *halves.frame;
    const uint32_t count = frame.field.vertex_count, middle = count / 2;
    halves.placed[half] = half == 0 ? put_vertices(frame, 0, middle) : put_vertices(frame, middle, count);
}

LUMI_ALWAYS_INLINE void list_patches(SurfaceHalves& halves, uint32_t half, const PatchRange& patches)
{
    const SurfaceFrame& frame = *halves.frame;
    Lister<want_light> lister(frame, half == 0 ? frame.memory.bands : halves.bands);
    for (uint32_t k = patches.begin; k < patches.end; ++k) lister.add(k, surface_patch(frame.field, k).corner);
    halves.reach[half] = lister.reach();
}

// Every other vertex: what faces the eye lies close together in the file.
void light_vertices(const SurfaceFrame& frame, uint32_t half)
{
    SurfaceVertex* const vertices = frame.memory.vertices;
    for (uint32_t k = half; k < frame.field.vertex_count; k += 2)
        if (vertices[k].colour == kWanted) vertices[k].colour = lit_colour(frame, k);
}

// Puts a list of the second half before that of the first.
void join_list(const SurfaceFrame& frame, uint16_t& first, uint16_t second)
{
    if (second == kEmptyBand) return;
    uint16_t* const links = frame.memory.links;
    uint32_t last = second;
    for (uint32_t next = after(last, links[last]); next != kEmptyBand; next = after(last, links[last])) last = next;
    if (first != kEmptyBand) links[last] = static_cast<uint16_t>((links[last] & ~kLinkMask) | first);
    first = second;
}

}  // namespace

bool begin_halves(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode, const SurfaceMemory& memory,
                  SurfaceFrame& out, SurfaceHalves& halves)
{
    const bool shows = begin_frame(field, camera, mode, memory, out);
    halves.frame = &out;
    halves.placed[0] = halves.placed[1] = kNotPlaced;
    halves.reach[0] = halves.reach[1] = 0;
    empty_bands(out, halves.bands);
    return shows;
}

void run_half(SurfaceHalves& halves, int32_t step, uint32_t half)
{
    switch (step) {
        case kPlaceVertices:
            return place_half(halves, half);
        case kListTriangles:
            return list_patches(halves, half, patches_of(halves.frame->field.patch_count, half));
        case kLightVertices:
            return light_vertices(*halves.frame, half);
        default:
            return;
    }
}

void begin_halves_of_body(SurfaceFrame& frame, SurfaceHalves& halves)
{
    halves.frame = &frame;
    halves.placed[0] = halves.placed[1] = kNotPlaced;
    halves.reach[0] = halves.reach[1] = 0;
    empty_bands(frame, halves.bands);
}

void run_half_of_body(SurfaceHalves& halves, int32_t step, uint32_t half)
{
    const SurfaceFrame& frame = *halves.frame;
    const OwnerRanges body = owner_ranges(frame.field, 0);
    if (step == kPlaceVertices) {
        const auto half_of = [&](const NumberRange& r) {
            const uint32_t middle = (r.begin + r.end) / 2;
            return half == 0 ? NumberRange{r.begin, middle} : NumberRange{middle, r.end};
        };
        PlacedVertices placed = kNothingPlaced;
        place_vertices(frame, half_of(body.viewed), placed);
        place_vertices(frame, half_of(body.plain), placed);
        halves.placed[half] = placed;
    } else if (step == kListTriangles) {
        list_patches(halves, half, patches_of(body.patches.end, half));
    } else if (step == kLightVertices) {
        light_vertices(frame, half);
    }
}

void join_vertices(SurfaceHalves& halves)
{
    const PlacedVertices &a = halves.placed[0], &b = halves.placed[1];
    set_extents(*halves.frame, {joined(a.x_q6, b.x_q6), joined(a.y_q6, b.y_q6), a.are_whole && b.are_whole});
}

void join_lists(SurfaceHalves& halves)
{
    SurfaceFrame& frame = *halves.frame;
    frame.reach = halves.reach[0] > halves.reach[1] ? halves.reach[0] : halves.reach[1];
    for (uint32_t k = 0; k <= frame.other_list; ++k) join_list(frame, frame.memory.bands[k], halves.bands[k]);
}

}  // namespace lumi::detail
