// SPDX-License-Identifier: MIT
// How fast parts draw a chord field: a model of instructions, fitted to what boards executed (docs/log/tradeoff.md),
// and of what the field's own rows of texels miss in the parts' caches.
#pragma once

#include <string>
#include <vector>

#include "planner/chord_work.h"
#include "planner/surface_speed.h"

namespace lumi::planner
{

// The span that rates are told for unless they say which.
inline constexpr int32_t kRatedSpanPx = 8;

// Instructions of a frame in RGB565 over black, whose work is frame_of()'s, with the code of `core` ("m0plus", "m4" or
// "m7"). Paper is that of 5 points a side.
double chord_instructions(const std::string& core, tools::Mode mode, const Field& field, int32_t span_px,
                          const ChordWork& work);

// Frames a second by one core, of a view that the sphere fills, in the order of kChipList; mean and worst are the same.
std::vector<PartRate> chord_rates(const Field& field, tools::Mode mode, int32_t span_px = kRatedSpanPx,
                                  const host::ScreenSize& screen = {});

}  // namespace lumi::planner
