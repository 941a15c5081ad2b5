// SPDX-License-Identifier: MIT
// Counts the work of a frame while core draws it, and what that costs: instructions, and reads from flash.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "draw/draw.h"
#include "draw/views.h"
#include "lumi/chord/render_spans.h"
#include "lumi/detail/work.h"
#include "lumi/surface/frame.h"
#include "planner/chips.h"

namespace lumi::planner
{

using detail::Work;

struct FrameWork {
    std::array<uint64_t, detail::kWorks> done{};

    uint64_t operator[](Work work) const { return done[static_cast<size_t>(work)]; }
};

// Counts of a frame, and what of it comes before the first stripe.
struct SurfaceWork {
    FrameWork frame, preparing;
};

// Counts a frame of RGB565 over black, in stripes of so many scanlines; nothing for a camera that core refuses.
SurfaceWork work_of(const SurfaceField& field, const tools::Eye& eye, SurfaceMode mode, int32_t stripe_rows);

// Whether a field is drawn by spans; else every pixel is drawn exactly, whatever span is asked for.
inline bool is_drawn_by_spans(const Field& field, tools::Mode mode, int32_t span_px)
{
    return span_px != 0 && mode != tools::Mode::paper && fits_spans(field);
}

struct ChordFrame {
    FrameWork work;
    std::vector<Read> reads;  // in the order of drawing; addresses count from the first texel
};

// span_px: 2 to 16, or 0 for exact pixels. Paper is that of 5 points a side.
ChordFrame frame_of(const Field& field, tools::Mode mode, int32_t span_px, const Camera& camera, int32_t stripe_rows);

// The cores whose instructions were counted. The M7's are taken for the M4's, whose code it runs.
inline constexpr const char* kCountedCores[] = {"m0plus", "m4", "m7"};

double instructions_of(const std::string& core, const FrameWork& work);

}  // namespace lumi::planner
