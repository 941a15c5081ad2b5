// SPDX-License-Identifier: MIT
// Neighbours and triangles share this: a direction as the lattice sees it.
#pragma once

#include "lumi/detail/lattice.h"

namespace lumi::detail
{

// Below this size every point is looked at: the pattern of one pole reaches into the other's.
inline constexpr uint32_t kSmallSize = 64;

// A query in the northern hemisphere; the south is its mirror image i -> n-1-i.
struct Query {
    uint32_t longitude_turns32;
    int32_t height_q10;  // real-valued index t
    int32_t z_q30;       // in [0, 1]
    bool mirrored;
};

Query make_query(const Lattice& lattice, const Vec3q30& direction);

// The `count` nearest points of a lattice below kSmallSize, or all, nearest first; count <= kMaxNeighbours. Returns how
// many.
uint32_t nearest_of_all(const Lattice& lattice, const Vec3q30& direction, uint32_t count, Neighbour* out);

// Returns the index of a query's hemisphere as an index of the lattice.
inline uint32_t unmirrored(const Lattice& lattice, const Query& query, uint32_t i)
{
    return query.mirrored ? lattice.size() - 1 - i : i;
}

// Lattice coordinates of a query in the basis (F_k, F_k+1) of its zone: the point with coordinates (a, b) has index
// F_k·a + F_k+1·b. The basis has determinant ±1, and adding a turn to the longitude moves (u, v) by (F_k+1, -F_k),
// which leaves every index as it is.
struct Cell {
    int zone;
    int32_t first, second;  // F_k, F_k+1
    int32_t u_q12, v_q12;
};

Cell cell_of(const Query& q);

// Whether the two steps of a cell's zone form an obtuse angle at the middle of the cell whose lowest corner is
// `corner`: then the cell's diagonal is their sum, else their difference. Decided for the cell, not for the query, so
// that neighbours agree and no seam opens where the diagonal flips; where the zone changes, both zones' triangles are
// the same, and the polar zone's are those of the pattern (zone_tables.h).
bool is_obtuse(const Lattice& lattice, const Cell& cell, int32_t corner);

}  // namespace lumi::detail
