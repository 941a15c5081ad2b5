// SPDX-License-Identifier: MIT
// How fast parts draw a chord field: a model of instructions that `lumi-lab bench` counted, and of what the field's own
// rows of texels miss in the parts' caches.
#pragma once

#include <string>
#include <vector>

#include "draw/draw.h"
#include "planner/surface_speed.h"

namespace lumi::planner
{

// Whether firmware draws the field by spans; else every pixel is drawn exactly, whatever span is asked for.
bool is_drawn_by_spans(const Field& field);

// The span that rates are told for unless they say which.
inline constexpr int32_t kRatedSpanPx = 8;

// Instructions of a pixel of the sphere with the code of `core` ("m0plus", else M4 code): docs/log/data/tradeoff.json,
// generic view, by the field's texel format; exact pixels in RGB565, of small lattices by docs/log/exact.md. Paper is
// that of 5 points a side. span_px: 4, 8 or 16; 0: every pixel exact.
double chord_instructions(const std::string& core, tools::Mode mode, const Field& field,
                          int32_t span_px = kRatedSpanPx);

// Frames a second by one core, of a view that the sphere fills. Spans take more in stripes whose rows are no multiple
// of 8, which the model does not know. In the order of kChipList; mean and worst are the same. Dither and true nearest
// points are taken to read what Nearest reads. Cost: the taps of such a frame.
std::vector<PartRate> chord_rates(const Field& field, tools::Mode mode, int32_t span_px = kRatedSpanPx,
                                  const host::ScreenSize& screen = {});

}  // namespace lumi::planner
