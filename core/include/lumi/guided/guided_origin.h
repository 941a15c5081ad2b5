// SPDX-License-Identifier: MIT
// The origins around a pixel: their charts made ready, kept while the pixel's origin triangle stays the same.
#pragma once

#include "lumi/guided/guided_chart.h"
#include "lumi/guided/guided_field.h"

namespace lumi
{

// The rows of one origin in a ChartTable.
struct ChartRows {
    const uint8_t* rows = nullptr;  // u16 each; row 0 is grid row first_row
    int32_t first_row = 0;
    uint32_t row_count = 0;
    uint32_t last_row = 0;  // the last of them, 0 where there is none
    uint32_t texel_base = 0;
    uint32_t texel_span = 0;  // texels from texel_base on that a row's 16 bits can address, at most 2^16
};
ChartRows chart_rows(const ChartTable& table, uint32_t origin);

// The same of a table of one byte each.
struct DepthRows {
    const uint8_t* rows = nullptr;
    int32_t first_row = 0;
    uint32_t row_count = 0;
    uint32_t depth_span = 0;
    const uint8_t* depths = nullptr;  // depth_span of them
};
DepthRows depth_rows(const ChartTable& table, uint32_t origin);

// A cell of the table of depths and how far its origin sees there, |X - p|² at most. Cells are wide: nearly every pixel
// asks for the one of the pixel before.
struct DepthCell {
    static constexpr uint32_t kNone = 0x7FFF7FFFu;  // farther away than any chart reaches

    uint32_t place = kNone;  // row above column
    uint32_t limit2_q28 = 0;
};

// A palette of 16 colours ready to sum: blue above red, and 1 above green; a missing texel's are 0. Differences are 128
// more each.
struct PackedColour {
    uint32_t rb, wg;
};
struct PackedPalette {
    PackedColour colour[16];
};

// What a pixel needs of an origin. An origin beyond the used ones has no rows: all of its texels are missing.
struct OriginChart {
    ChartAxes axes{};
    mutable DepthCell seen;  // of occlusion, as it was asked last: a function of the chart alone
    int32_t origin = -1;
    ChartRows texels;
    DepthRows occlusion;
    const uint8_t* colours = nullptr;  // its palette
    PackedPalette packed;              // with GuidedTexel::index4
};

// The corners of a pixel's origin triangle. Weights sum to 2^8.
struct OriginTaps {
    int32_t index[3];
    uint32_t weight_q8[3];
};

// Keeps the charts of the last triangle's corners, and the frames of recent origins. 1,124 bytes on a 32-bit core.
class OriginCharts
{
public:
    explicit OriginCharts(const GuidedField& field) : field_(field) {}

    // Whether chart(k) is that of origin `index`.
    bool holds(int k, int32_t index) const { return chart_[k]->origin == index; }
    const OriginChart& chart(int k) const { return *chart_[k]; }
    // Makes chart(0 .. 2) those of a triangle's corners. Costs about 330 instructions a corner that was not there, 100
    // of them its palette, and some 500 more if its frame is not known.
    void hold(const int32_t (&index)[3]);
    // Makes chart(0) that of one origin.
    void hold_one(int32_t index);

private:
    // What a chart's axes are made of.
    struct Frame {
        int16_t origin = -1;
        ChartPoint p{};
        ChartFrame frame{};
    };
    static_assert(format::kMaxGuidedOrigins <= 32768, "an origin's index fits 16 bits");
    // Indices of a triangle's corners differ by Fibonacci numbers; none up to the largest lattice's is a multiple of 16
    // but 144.
    static constexpr uint32_t kFrames = 16;

    void make(int32_t index, OriginChart& out);
    const Frame& frame(int32_t index);

    OriginChart* chart_[3] = {&slot_[0], &slot_[1], &slot_[2]};
    const GuidedField& field_;
    OriginChart slot_[3] = {};
    Frame frame_[kFrames];
};

}  // namespace lumi
