// SPDX-License-Identifier: MIT
// The parts of a guided field as the baker makes them, before they are packed (lumi/guided_format.h).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lumi/color.h"
#include "lumi/guided/guided_format.h"
#include "proxy/packed_proxy.h"

namespace lumi::baker
{

// Mean colours in bricks of 4×4×4 nodes. Resolution 0: the field has none.
struct PackedMean {
    uint32_t resolution = 0;
    format::MeanFormat format = format::MeanFormat::rgb565;
    std::array<uint8_t, 3> first_brick{}, box{};
    std::vector<Rgb8> palette;     // palette8 only, at most 256
    std::vector<uint16_t> index;   // of the brick at each place of the box
    std::vector<uint16_t> bricks;  // 64 nodes each: RGB565, or entries of the palette
};

// The rows of one origin's chart, and the place of each in the origin's texels.
struct ChartRows {
    struct Row {
        uint32_t first_u, count, at;
    };
    uint32_t first_v = 0;
    std::vector<Row> rows;
    uint32_t texel_count = 0;
};

// One byte a texel, whatever the file packs it to.
struct PackedChart {
    ChartRows rows;
    std::vector<uint8_t> texels;
};

struct GuidedParts {
    uint32_t origins = 0;  // M
    uint32_t chart_size = 0;
    format::GuidedTexel texel = format::GuidedTexel::none;
    format::GuidedSurface surface = format::GuidedSurface::proxy;
    uint32_t origins_per_palette = 1;
    std::array<float, 3> centre{};  // scene units, scene axes
    float radius = 1;
    std::array<int16_t, 3> focus_q14{};
    uint16_t focus_radius_q14 = 0;

    PackedProxy proxy;                  // with GuidedSurface::proxy
    PackedMean mean;                    // optional
    uint32_t used_origins = 0;          // charts below are of these
    std::vector<PackedChart> charts;    // unless GuidedTexel::none
    std::vector<uint8_t> colours;       // kChartColours' bytes
    std::vector<PackedChart> occluded;  // optional
};

}  // namespace lumi::baker
