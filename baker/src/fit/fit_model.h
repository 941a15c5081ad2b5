// SPDX-License-Identifier: MIT
// The colours of a surface field before they are quantised, and where a sample lies among them.
#pragma once

#include "fit/encoded_tone.h"
#include "fit/sample_tracer.h"

namespace lumi::baker
{

inline constexpr uint32_t kPatchNodes = 4 * detail::format::kViewNodes;  // the nodes of a patch's four corners

struct FitModel {
    std::vector<LevelColour> texels;
    std::vector<LevelColour> nodes;  // kViewNodes a vertex
    std::vector<Rgb> matt;           // by texel: the mean of its light paths' PathResult::matt
    std::vector<float> alike;        // by patch, 0 .. 1: how surely all views see that light alike
    std::vector<uint8_t> viewed;     // by vertex: not 0 where it has a view table; elsewhere nodes are 0
};

template <class Io>
void fields(Io& io, FitModel& model)
{
    io(model.texels, model.nodes, model.matt, model.alike, model.viewed);
}

// Each vertex of opaque patches has a table.
FitModel empty_model(const FitShape& shape);
bool is_of(const FitModel& model, const FitShape& shape);
// Makes nodes of vertices that are not viewed 0.
void flatten_unviewed(FitModel& model);

// The nodes that a sample sees, and their weights; those of no weight and of vertices without a table are left out.
struct SampleTaps {
    struct Tap {
        uint16_t node;  // corner · kViewNodes + node, < kPatchNodes
        int16_t weight_q12;
    };
    std::array<Tap, 9> taps;
    uint32_t count = 0;
};
SampleTaps taps_of(const FitShape& shape, const FitSample& sample, const std::vector<uint8_t>& viewed);

// Returns the levels that the model shows for a sample; `nodes` are those of its patch, kPatchNodes of them.
LevelColour predicted(const FitModel& model, const std::vector<LevelColour>& nodes, const FitSample& sample,
                      const SampleTaps& taps);
// The nodes of a patch's corners, in order; those of a missing corner are 0.
std::vector<LevelColour> patch_nodes(const FitShape& shape, const FitModel& model, uint32_t patch);

}  // namespace lumi::baker
