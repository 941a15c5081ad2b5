// SPDX-License-Identifier: MIT
#include "surface/surface_model.h"

#include "lumi/surface_format.h"

namespace lumi::baker
{
namespace
{

constexpr int kOneQ12 = 4096;

}  // namespace

SurfaceModel empty_model(const SurfaceShape& shape)
{
    return {std::vector<LevelColour>(shape.layout.texels),
            std::vector<LevelColour>(shape.mesh.positions.size() * format::kViewNodes)};
}

SampleTaps taps_of(const SurfaceShape& shape, const SurfaceSample& s)
{
    SampleTaps result;
    const int weights[3] = {kOneQ12 - s.second_q12 - s.third_q12, s.second_q12, s.third_q12};
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t corner = SurfaceShape::patch_corner(s.triangle, k);
        const ViewTaps seen = shape.taps(shape.vertex(s.triangle / 2, corner), s.eye);
        for (int tap = 0; tap < 3; ++tap) {
            const int weight = (std::max(weights[k], 0) * seen.weight_q8[tap] + 128) >> 8;
            if (weight != 0) {
                result.taps[result.count++] = {static_cast<uint16_t>(corner * format::kViewNodes + seen.node[tap]),
                                               static_cast<int16_t>(weight)};
            }
        }
    }
    return result;
}

LevelColour predicted(const SurfaceModel& model, const std::vector<LevelColour>& nodes, const SurfaceSample& sample,
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

std::vector<LevelColour> patch_nodes(const SurfaceShape& shape, const SurfaceModel& model, uint32_t patch)
{
    std::vector<LevelColour> nodes(kPatchNodes);
    for (uint32_t corner = 0; corner < 4; ++corner) {
        const uint32_t v = shape.vertex(patch, corner);
        if (v != SurfaceMesh::kNone) {
            std::copy_n(model.nodes.begin() + v * format::kViewNodes, format::kViewNodes,
                        nodes.begin() + corner * format::kViewNodes);
        }
    }
    return nodes;
}

}  // namespace lumi::baker
