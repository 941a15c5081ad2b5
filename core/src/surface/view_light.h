// SPDX-License-Identifier: MIT
// How the view table of a vertex is read for an eye.
#pragma once

#include "lumi/surface/detail/view_nodes.h"
#include "lumi/surface/frame.h"

namespace lumi::detail
{

// Three signed fields of 10 bits below each other, see red_q2.
LUMI_ALWAYS_INLINE uint32_t packed_fields(int32_t r_q2, int32_t g_q2, int32_t b_q2)
{
    const auto field = [](int32_t v) { return static_cast<uint32_t>(v < -511 ? -511 : v > 511 ? 511 : v) & 0x3FF; };
    return field(r_q2) << 22 | field(g_q2) << 12 | field(b_q2) << 2;
}

// Does that where the fields mostly need no bounds.
LUMI_ALWAYS_INLINE uint32_t packed_small_fields(int32_t r_q2, int32_t g_q2, int32_t b_q2)
{
    constexpr int32_t kMost = 511;
    const auto shifted = [](int32_t v) { return static_cast<uint32_t>(v + kMost); };
    if (__builtin_expect((shifted(r_q2) | shifted(g_q2) | shifted(b_q2)) > 2 * kMost, 0))
        return packed_fields(r_q2, g_q2, b_q2);
    const auto field = [](int32_t v) { return static_cast<uint32_t>(v) & 0x3FF; };
    return field(r_q2) << 22 | field(g_q2) << 12 | field(b_q2) << 2;
}

// Which of its colours a node has. What follows the last code in a record is read, too.
LUMI_ALWAYS_INLINE uint32_t code_of(const uint8_t* record, uint32_t node, uint32_t bits)
{
    const uint32_t at = node * bits;
    const uint8_t* p = record + (at >> 3);
    const auto pair = static_cast<uint32_t>(p[0] | p[1] << 8);
    return pair >> (at & 7) & ((1u << bits) - 1);
}

inline int32_t signed_byte(const uint8_t* p)
{
    return static_cast<int32_t>(static_cast<int8_t>(*p));
}

// The nodes around the direction from a vertex to the eye. `turn` lies in its record.
LUMI_ALWAYS_INLINE ViewTaps taps_of_vertex(const SurfaceField& field, const SurfaceProjection& p, uint32_t vertex,
                                           const uint8_t* turn)
{
    const VertexQ14 v = surface_vertex(field, vertex);
    const ViewDirection to_eye = {p.viewer.x - (v.x >> p.viewer_shift), p.viewer.y - (v.y >> p.viewer_shift),
                                  p.viewer.z - (v.z >> p.viewer_shift)};
    const ViewDirection d = in_view_frame(to_eye, signed_byte(turn), signed_byte(turn + 1), signed_byte(turn + 2));
    return view_taps(d.x, d.y, d.z);
}

}  // namespace lumi::detail
