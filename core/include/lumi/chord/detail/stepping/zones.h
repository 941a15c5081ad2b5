// SPDX-License-Identifier: MIT
// The zones of one lattice as stepping needs them: where they begin, and how longitude and height become coordinates.
//
// Within a zone the coordinates (u, v) of a direction are linear in its longitude and its height (lattice.h evaluates
// them for one direction), so that a scanline needs them at a few pixels only.
#pragma once

#include "lumi/detail/lattice.h"

namespace lumi::detail
{

// Larger lattices are drawn by the exact renderer: 16-bit viewing vectors do not resolve their cells.
inline constexpr uint32_t kMaxSpanLattice = 65536;
// Smaller ones too: they have no zones to speak of.
inline constexpr uint32_t kMinSpanLattice = 64;
// Zones end where the pole's own pattern begins (a real-valued index): F_8 = 21, and one for the rounding of heights.
inline constexpr int32_t kPolarHeight = 22;

inline constexpr int kFirstSpanZone = 6;  // the one that reaches up to kPolarHeight, for every size
inline constexpr int kSpanZones = 8;      // 6 .. 13

// Heights are |z|, Q30, so that a zone is found by comparisons alone.
struct Zone {
    int32_t begin_z_q30;       // the zone holds |z| below this, down to the next zone's
    int32_t obtuse_z_q30;      // its steps form an obtuse angle below this
    int32_t obtuse_index_q10;  // cells are cut as obtuse from this height of their middle on, a real-valued index
    int16_t scale_u, scale_v, shift;  // height to u, v: mantissas below 2^14, then a shift right
    int16_t number;                   // k: its steps are F_k and F_k+1
    int32_t origin_u_q16, origin_v_q16;
};

// Computed once per stripe. 244 bytes.
struct LatticeZones {
    int32_t size;
    int32_t polar_z_q30;     // |z| at kPolarHeight
    int32_t mirror_turns20;  // longitude of point n-1, Q20: the mirror image of longitude p is mirror - p
    int32_t mirror_cos_q15, mirror_sin_q15;
    int32_t step_z_q30;  // 1/n: half a point's share of the height
    Zone zone[kSpanZones];

    explicit LatticeZones(const Lattice& lattice);
};

}  // namespace lumi::detail
