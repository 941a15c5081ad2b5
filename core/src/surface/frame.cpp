// SPDX-License-Identifier: MIT
// A frame's vertices and lists of triangles.
#include "surface/preparing.h"
#include "surface/view_light.h"

namespace lumi::detail
{
namespace
{

static_assert(2 * format::kMaxPatches <= kLinkMask + 1, "a link holds every triangle's number");
static_assert(kBandReach <= 1 << (16 - kLinkBits), "and how far it reaches");

}  // namespace

uint32_t lit_colour(const SurfaceFrame& frame, uint32_t vertex)
{
    if (vertex >= frame.field.lit_count) return 0;
    LUMI_TALLY(Work::lit, 1);
    const uint32_t bits = frame.field.code_bits;
    const uint8_t* record = frame.field.views + vertex * format::view_bytes(bits);
    const uint8_t* turn = record + format::view_turn_at(bits);
    const ViewTaps taps = taps_of_vertex(frame.field, frame.projection, vertex, turn);
    int32_t r = 0, g = 0, b = 0;
    for (int m = 0; m < 3; ++m) {
        const uint32_t node = taps.node[m];
        const uint32_t which = (node << bits) + code_of(record, node, bits);
        const uint8_t* colour = frame.field.node_colours + which * format::kNodeColourBytes;
        const int32_t weight = taps.weight_q8[m];
        r += weight * signed_byte(colour);
        g += weight * signed_byte(colour + 1);
        b += weight * signed_byte(colour + 2);
    }
    // Weights have 8 bits of fraction, gains 6, the result 2.
    const uint8_t* gain = turn + format::kTurnBytes;
    return packed_fields((r * gain[0] + 2048) >> 12, (g * gain[1] + 2048) >> 12, (b * gain[2] + 2048) >> 12);
}

namespace
{

void put_triangles(SurfaceFrame& frame)
{
    Lister<light> lister(frame, frame.memory.bands);
    for (uint32_t k = 0; k < frame.field.patch_count; ++k) lister.add(k, surface_patch(frame.field, k).corner);
    frame.reach = lister.reach();
}

// Whether a patch's nth side may be an outline, since nothing that faces the eye and has samples lies across, or is a
// crease.
LUMI_ALWAYS_INLINE uint32_t is_outline(const SurfaceFrame& frame, const uint8_t* neighbours, uint32_t n)
{
    const uint32_t word = static_cast<uint32_t>(neighbours[2 * n] | neighbours[2 * n + 1] << 8);
    const uint32_t across = word & format::kNeighbourMask;
    return across == format::kNoNeighbour || frame.memory.links[across] >= kWithoutSamples ? 1 : word / format::kCrease;
}

// Bits of the sides of a patch's first triangle that are outlines, numbered as in side_of(); `other`: the second's
// link.
LUMI_ALWAYS_INLINE uint32_t first_outlines(const SurfaceFrame& frame, uint32_t patch, const uint8_t* neighbours,
                                           uint32_t other)
{
    const uint32_t sides = is_outline(frame, neighbours, 0) | is_outline(frame, neighbours, 1) << 1;
    if (other < kWithoutSamples) return sides;
    const bool is_alone = surface_patch(frame.field, patch).corner[3] == format::kNoVertex;
    return sides | (is_alone ? is_outline(frame, neighbours, 2) : 1) << 2;
}

// Returns those of the second triangle; `other`: the first's link.
LUMI_ALWAYS_INLINE uint32_t second_outlines(const SurfaceFrame& frame, const uint8_t* neighbours, uint32_t other)
{
    return is_outline(frame, neighbours, 2) | is_outline(frame, neighbours, 3) << 1 |
           (other >= kWithoutSamples ? 1u : 0u) << 2;
}

}  // namespace

void prepare(const SurfaceField& field, const SurfaceCamera& camera, SurfaceMode mode, const SurfaceMemory& memory,
             SurfaceFrame& out)
{
    if (!begin_frame(field, camera, mode, memory, out)) return;
    set_extents(out, put_vertices(out, 0, field.vertex_count));
    put_triangles(out);
}

void put_outlines(const SurfaceFrame& frame, uint32_t begin, uint32_t end)
{
    LUMI_TALLY(Work::bordered, end - begin);
    const uint16_t* link = frame.memory.links + 2 * begin;
    const uint8_t* neighbour = frame.field.neighbours + begin * format::kNeighbourBytes;
    uint8_t* const sides = outline_sides(frame);
    for (uint32_t patch = begin; patch < end; ++patch) {
        uint32_t bits = 0;
        if (link[0] < kWithoutSamples) bits = first_outlines(frame, patch, neighbour, link[1]);
        if (link[1] < kWithoutSamples) bits |= second_outlines(frame, neighbour, link[0]) << kSideBits;
        sides[patch] = static_cast<uint8_t>(bits);
        link += 2;
        neighbour += format::kNeighbourBytes;
    }
}

}  // namespace lumi::detail
