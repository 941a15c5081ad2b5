// SPDX-License-Identifier: MIT
// What a surface bake keeps, as bytes: for checkpoints and shards.
#pragma once

#include <optional>

#include "lumi/baker/surface.h"
#include "surface/surface_solution.h"
#include "util/byte_stream.h"

namespace lumi::baker
{

void put(ByteWriter& out, const Vec3& v);
Vec3 get_vector(ByteReader& in);

// What all shards of a bake have in common, and a merge has no scene for.
struct SurfaceBasis {
    SurfaceMesh mesh;
    std::vector<float> densities;  // texels a radius, by patch
    ProxyLoss loss;
    ToneCurve tone;
    SurfaceSphere sphere;
};

std::vector<uint8_t> encode(const SurfaceBasis& basis);
// Nothing if the bytes are of no basis.
std::optional<SurfaceBasis> decode_basis(const std::vector<uint8_t>& bytes);

// The pilot's result and the sums.
std::vector<uint8_t> encode(const SurfaceState& state);
// Whether all batches are in the sums.
bool is_complete(const std::vector<uint8_t>& state);
// Adds the sums to `state`, which takes the pilot's result if it has none. False, with the state spoiled, if the bytes
// are of another pilot or of no state of this shape.
bool add_encoded(const std::vector<uint8_t>& bytes, SurfaceState& state);

}  // namespace lumi::baker
