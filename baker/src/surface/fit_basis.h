// SPDX-License-Identifier: MIT
// What all shards of a bake have in common, and a merge has no scene for.
#pragma once

#include <optional>

#include "pack/solution.h"

namespace lumi::baker
{

struct FitBasis {
    PatchMesh mesh;
    std::vector<float> densities;  // texels a radius, by patch
    MeshLoss loss;
    ToneCurve tone;
    FieldSphere sphere;
    std::vector<SeeThroughTexel> see_through;  // FitShape
};

// As bytes for checkpoints and shards.
std::vector<uint8_t> encode(const FitBasis& basis);
// Nothing if the bytes are of no basis.
std::optional<FitBasis> decode_basis(const std::vector<uint8_t>& bytes);

}  // namespace lumi::baker
