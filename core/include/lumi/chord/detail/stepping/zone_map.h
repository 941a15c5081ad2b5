// SPDX-License-Identifier: MIT
// The zones of one lattice as stepping needs them, and the map of a zone: lattice coordinates (u, v) as linear
// functions of a hit's longitude and height. One map serves beyond its zone's border, too: there its cells are still
// the next zone's.
#pragma once

#include "lumi/chord/detail/stepping/hits.h"
#include "lumi/chord/detail/stepping/lattice_line.h"
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

// It is computed once a stripe and takes 244 bytes.
struct LatticeZones {
    int32_t size;
    int32_t polar_z_q30;     // |z| at kPolarHeight
    int32_t mirror_turns20;  // longitude of point n-1, Q20: the mirror image of longitude p is mirror - p
    int32_t mirror_cos_q15, mirror_sin_q15;
    int32_t step_z_q30;  // 1/n: half a point's share of the height
    Zone zone[kSpanZones];

    explicit LatticeZones(const Lattice& lattice);
};

// Spans and tiles that turn further are not drawn in one piece.
inline constexpr int32_t kMaxTurnQ20 = 1 << 16;  // 1/16 turn

// Coordinates in a map are below 2^10 cells.
struct LatticePoint {
    int32_t u_q16, v_q16;
};

class ZoneMap
{
public:
    explicit ZoneMap(const LatticeZones& zones) : zones_(zones) {}

    // Chooses the zone of a hit, no nearer to a pole than kPolarHeight, and writes its steps into `line`.
    void choose(int32_t z_q30, CellLine& line);
    // No zone: nothing holds until choose().
    void leave() { low_z_q30_ = high_z_q30_ = 0; }
    // Whether the zone is the exact one at this height.
    bool holds(int32_t z_q30) const { return z_q30 >= low_z_q30_ && z_q30 < high_z_q30_; }
    // Between which heights the map may be used at all: no corner of a cell lies beyond a pole.
    int32_t lowest_z_q30() const { return lowest_z_q30_; }
    int32_t highest_z_q30() const { return highest_z_q30_; }
    bool reaches(int32_t z_q30) const { return z_q30 >= lowest_z_q30_ && z_q30 <= highest_z_q30_; }
    // Whether no cell around this height is flipped.
    bool is_uniform_at(int32_t z_q30) const { return z_q30 >= uniform_low_z_q30_ && z_q30 <= uniform_high_z_q30_; }

    // Longitudes within two turns of 0: products with steps of up to 377 stay below 2^30.
    LatticePoint at(int32_t longitude_q20, int32_t z_q16) const
    {
        const LatticePoint from_origin = change(longitude_q20, z_q16);
        return {u_q16_ + from_origin.u_q16, v_q16_ + from_origin.v_q16};
    }
    // How far coordinates change with longitude and height.
    LatticePoint change(int32_t longitude_q20, int32_t z_q16) const
    {
        return {((u_longitude_ * longitude_q20) >> 4) + ((u_z_ * z_q16) >> shift_),
                ((v_longitude_ * longitude_q20) >> 4) + ((v_z_ * z_q16) >> shift_)};
    }

    const LatticeZones& zones() const { return zones_; }

private:
    int32_t pole_distance_z_q30(int32_t points) const;
    void set_borders(const Zone& z, bool mirrored, bool acute, int32_t first, int32_t second);

    const LatticeZones& zones_;
    int32_t u_q16_ = 0, v_q16_ = 0, u_longitude_ = 0, v_longitude_ = 0, u_z_ = 0, v_z_ = 0, shift_ = 0;
    int32_t low_z_q30_ = 0, high_z_q30_ = 0;  // signed z range in which the zone is exact; empty: there is none yet
    int32_t uniform_low_z_q30_ = 0, uniform_high_z_q30_ = 0;
    int32_t lowest_z_q30_ = 0, highest_z_q30_ = 0;
    int zone_ = 0;
};

// One lattice of the stripe being drawn: what spans and tiles follow it with, by turns.
struct LatticeTrack {
    LatticeTrack(const LatticeZones& zones, Hit HitPair::*of) : map(zones), hit(of), line{} {}

    // A hit's place in the plane of the polar pattern, Q16; `mirrored` for the pole below.
    LatticePoint in_plane(const HitPair& at, bool mirrored) const;
    // Leaves the map behind: the line counts from a pole.
    void enter_pole(bool mirrored);
    // Makes the line lead over the pole from one place in the plane on, by a step a pixel.
    void set_polar(const LatticePoint& from, const LatticePoint& step_q16);

    ZoneMap map;
    Hit HitPair::*hit;
    LatticeLine line;
};

}  // namespace lumi::detail
