// SPDX-License-Identifier: MIT
// Written by `tools/lab/proof/costs.py --fit`: instructions of a unit of each kind of work, in the order of
// detail::Work.
#pragma once

#include "lumi/detail/work.h"

namespace lumi::planner
{

struct UnitCost {
    const char* unit;
    double m0plus, m4;
};

// clang-format off
inline constexpr UnitCost kUnitCosts[] = {
    {"background", 4.212, 2.37},
    {"frame", 0, 3.62e+04},
    {"vertex", 245.6, 145.1},
    {"patch", 357.7, 208.9},
    {"listed", 268.3, 207.5},
    {"lit", 473.3, 270.7},
    {"bordered", 40.43, 17.35},
    {"see_triangle", 527.1, 278},
    {"ordered", 115, 34.82},
    {"stripe", 0, 1297},
    {"word", 1.171, 0.8139},
    {"see_word", 2.511, 2.363},
    {"link", 29.11, 19.67},
    {"offered", 127.8, 94.14},
    {"boxed", 0, 0},
    {"looked_at", 4.563, 4.381},
    {"begun", 806.3, 461.3},
    {"wide", 232.3, 135.7},
    {"split", 3374, 1220},
    {"split_part", 2808, 1063},
    {"row", 30.55, 29.16},
    {"filled", 37.11, 15.46},
    {"sample", 8.314, 6.659},
    {"shown", 24.74, 16.46},
    {"two_taps_sample", 20.63, 16.07},
    {"two_taps_shown", 24.23, 14.04},
    {"packed_sample", 10.91, 10.13},
    {"packed_shown", 33.61, 19.6},
    {"bilinear_sample", 30.37, 21.96},
    {"bilinear_shown", 68.05, 45.98},
    {"see_sample", 13.58, 9.08},
    {"see_shown", 87.51, 50.48},
    {"see_two_taps_sample", 40.38, 15.38},
    {"see_two_taps_shown", 102.4, 73.87},
    {"see_bilinear_sample", 106.3, 56.51},
    {"see_bilinear_shown", 27.85, 45.22},
    {"mixed_texels", 93.54, 40.55},
    {"clamped", 0, 0},
    {"see_alone", 58.36, 35.22},
    {"outline", 173.5, 80.29},
    {"edge", 646.2, 450.2},
    {"line", 0, 1.262},
    {"marked", 419.6, 321.4},
    {"four", 23.8, 23.46},
    {"four_whole", 0, 0},
    {"four_apart", 178.1, 147.6},
    {"four_mixed", 567.7, 298.8},
    {"gloss_vertex", 255, 140},
    {"gloss_texel", 400, 197},
    {"gloss_begun", 986, 634},
    {"gloss_shown", 75.4, 36.3},
    {"gap", 232.7, 205.3},
    {"tile_side", 922.6, 473.9},
    {"span_side", 465.2, 274.2},
    {"zone", 244.1, 239},
    {"polar_side", 705.1, 374.6},
    {"piece", 199.9, 123.7},
    {"pixel", 96.27, 55.76},
    {"pixel_rgb565", 74.52, 32.05},
    {"pixel_palette8", 121, 64.02},
    {"pixel_luma8", 95.74, 46.93},
    {"linear_piece", 331.1, 167.8},
    {"linear_pixel", 246.7, 122.2},
    {"linear_pixel_rgb565", 228.7, 130.3},
    {"linear_pixel_palette8", 259.9, 130.7},
    {"linear_pixel_luma8", 125.9, 70.41},
    {"flipped_pixel", 14.09, 19.52},
    {"checked_pixel", 145.6, 81.01},
    {"checked_linear", 368.9, 227.1},
    {"checked_row", 53.14, 22.88},
    {"exact", 6229, 1053},
    {"zone_step", 18.01, 29.72},
    {"distance", 181.9, 122.9},
    {"scanned", 1439, 249.7},
    {"polar_triangle", 2976, 1434},
    {"hull_triangle", 5.989e+04, 1.149e+04},
    {"tap", 50.47, 27.64},
};
// clang-format on
static_assert(sizeof kUnitCosts / sizeof *kUnitCosts == detail::kWorks, "each kind of work has a row");

}  // namespace lumi::planner
