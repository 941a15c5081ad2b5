// SPDX-License-Identifier: MIT
// Texels of charts as entries of palettes, one palette for a group of origins.
#pragma once

#include "guided/guided_parts.h"
#include "guided/mean_voxels.h"
#include "util/job.h"

namespace lumi::baker
{

// What the texels of one origin should show: colours, or differences from the mean.
struct ChartColours {
    std::vector<Levels> levels;
    std::vector<uint8_t> known;  // 0: missing
};

struct Palettes {
    uint32_t origins_per_palette = 1;
    std::vector<uint8_t> colours;              // the bytes of the section
    std::vector<std::vector<uint8_t>> texels;  // of each origin
};

// How many origins share a palette, so that palettes take a small share of the file.
uint32_t origins_per_palette(uint64_t texels, size_t origins, format::GuidedTexel texel);

// Entry 0 of each palette is the missing texel. The same colours give the same bytes for any number of threads.
Palettes palettes_of(const std::vector<ChartColours>& charts, format::GuidedTexel texel, bool differences, Job& job);

}  // namespace lumi::baker
