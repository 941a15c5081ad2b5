// SPDX-License-Identifier: MIT
// The zones of the lattice, for every n: powers of the golden ratio and Fibonacci numbers.
//
// In zone k, where Φ^2k <= √5·π·n·(1 - z²) < Φ^(2k+2), the shortest steps between points are the index differences F_k
// and F_k+1 (Keinert et al. 2015, section 3). From Φ^(2k+1) on they form an obtuse angle.
#pragma once

#include <stdint.h>

namespace lumi::detail
{

inline constexpr int32_t kFibonacci[17] = {0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 233, 377, 610, 987};
// Up to n = 2^20, where Keinert's zone at the equator would be 16: the cells' triangles are the same.
inline constexpr int kZones = 16;

// The zone that meets the polar pattern takes over its triangles: there, for every n, cells are obtuse whose middle
// lies at this real-valued index or above.
inline constexpr int kPolarZone = 6;
inline constexpr int32_t kObtuseHeight = 19;

struct ZoneTables {
    uint32_t threshold_q10[2 * kZones];     // n·(1 - z²) = Φ^m/(√5·π)
    int32_t inverse_power_q30[kZones + 1];  // Φ^-k, the longitude step of F_k in turns
};
extern const ZoneTables kZoneTables;

}  // namespace lumi::detail
