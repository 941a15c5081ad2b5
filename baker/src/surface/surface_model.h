// SPDX-License-Identifier: MIT
// The colours of a surface field before they are quantised, and where a sample lies among them.
#pragma once

#include "surface/encoded_tone.h"
#include "surface/surface_tracer.h"

namespace lumi::baker
{

inline constexpr uint32_t kPatchNodes = 4 * format::kViewNodes;  // of a patch's corners

struct SurfaceModel {
    std::vector<LevelColour> texels;
    std::vector<LevelColour> nodes;  // kViewNodes a vertex
};

SurfaceModel empty_model(const SurfaceShape& shape);

// The nodes that a sample sees, and their weights; those of no weight are left out.
struct SampleTaps {
    struct Tap {
        uint16_t node;  // corner · kViewNodes + node, < kPatchNodes
        int16_t weight_q12;
    };
    std::array<Tap, 9> taps;
    uint32_t count = 0;
};
SampleTaps taps_of(const SurfaceShape& shape, const SurfaceSample& sample);

// What the model shows of a sample; `nodes` are those of its patch, kPatchNodes of them.
LevelColour predicted(const SurfaceModel& model, const std::vector<LevelColour>& nodes, const SurfaceSample& sample,
                      const SampleTaps& taps);
// Of a patch's corners, in order; those of a missing corner are 0.
std::vector<LevelColour> patch_nodes(const SurfaceShape& shape, const SurfaceModel& model, uint32_t patch);

}  // namespace lumi::baker
