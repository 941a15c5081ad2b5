// SPDX-License-Identifier: MIT
// Where the texels of each patch lie (lumi/surface/format.h).
#pragma once

#include "mesh/patch_mesh.h"

namespace lumi::baker
{

// n × m texels from `begin` on, row after row.
struct PatchRectangle {
    uint32_t begin, n, m;

    uint32_t size() const { return n * m; }
};

struct TexelLayout {
    std::vector<PatchRectangle> rectangles;  // by patch
    uint32_t texels = 0;                     // length of the section, unused ones at its end included
};

// Sides follow the lengths of a patch's edges, times texels a radius, by patch; of any size.
TexelLayout unlimited_layout(const PatchMesh& mesh, const std::vector<float>& densities);
// Throws BakeError where the format cannot hold so many texels.
TexelLayout layout_of(const PatchMesh& mesh, const std::vector<float>& densities);
// The same density everywhere.
TexelLayout layout_of(const PatchMesh& mesh, float texels_per_radius);

// The texel at a point of a patch's first or second triangle, by the barycentric weights of its second and third
// corner.
uint32_t texel_at(const PatchRectangle& rectangle, bool second_triangle, float weight_of_second, float weight_of_third);

}  // namespace lumi::baker
