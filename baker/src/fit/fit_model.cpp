// SPDX-License-Identifier: MIT
#include "fit/fit_model.h"

#include "lumi/surface/format.h"

namespace lumi::baker
{
namespace
{

constexpr int kOneQ12 = 4096;

}  // namespace

FitModel empty_model(const FitShape& shape)
{
    return {std::vector<LevelColour>(shape.layout.texels),
            std::vector<LevelColour>(shape.mesh.positions.size() * detail::format::kViewNodes),
            std::vector<Rgb>(shape.layout.texels), std::vector<float>(shape.mesh.patches.size()),
            viewable_vertices(shape.mesh)};
}

SampleTaps taps_of(const FitShape& shape, const FitSample& s, const std::vector<uint8_t>& viewed)
{
    SampleTaps result;
    const int weights[3] = {kOneQ12 - s.second_q12 - s.third_q12, s.second_q12, s.third_q12};
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t corner = FitShape::patch_corner(s.triangle, k);
        const uint32_t vertex = shape.vertex(s.triangle / 2, corner);
        if (viewed[vertex] == 0) continue;
        const detail::ViewTaps seen = shape.taps(vertex, s.eye);
        for (int tap = 0; tap < 3; ++tap) {
            const int weight = (std::max(weights[k], 0) * seen.weight_q8[tap] + 128) >> 8;
            if (weight != 0) {
                result.taps[result.count++] = {
                    static_cast<uint16_t>(corner * detail::format::kViewNodes + seen.node[tap]),
                    static_cast<int16_t>(weight)};
            }
        }
    }
    return result;
}

LevelColour predicted(const FitModel& model, const std::vector<LevelColour>& nodes, const FitSample& sample,
                      const SampleTaps& taps)
{
    constexpr float kUnit = 1.0f / kOneQ12;
    LevelColour sum = model.texels[sample.texel];
    for (uint32_t k = 0; k < taps.count; ++k) {
        const LevelColour& node = nodes[taps.taps[k].node];
        const float weight = kUnit * static_cast<float>(taps.taps[k].weight_q12);
        for (size_t c = 0; c < 3; ++c) sum[c] += weight * node[c];
    }
    return sum;
}

std::vector<LevelColour> patch_nodes(const FitShape& shape, const FitModel& model, uint32_t patch)
{
    std::vector<LevelColour> nodes(kPatchNodes);
    for (uint32_t corner = 0; corner < 4; ++corner) {
        const uint32_t v = shape.vertex(patch, corner);
        if (v != PatchMesh::kNone) {
            std::copy_n(model.nodes.begin() + v * detail::format::kViewNodes, detail::format::kViewNodes,
                        nodes.begin() + corner * detail::format::kViewNodes);
        }
    }
    return nodes;
}

bool is_of(const FitModel& model, const FitShape& shape)
{
    const FitModel empty = empty_model(shape);
    return model.texels.size() == empty.texels.size() && model.nodes.size() == empty.nodes.size() &&
           model.matt.size() == empty.matt.size() && model.alike.size() == empty.alike.size() &&
           model.viewed.size() == empty.viewed.size();
}

void flatten_unviewed(FitModel& model)
{
    for (size_t k = 0; k < model.nodes.size(); ++k)
        if (model.viewed[k / detail::format::kViewNodes] == 0) model.nodes[k] = {};
}

}  // namespace lumi::baker
