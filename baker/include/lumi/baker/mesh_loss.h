// SPDX-License-Identifier: MIT
// How well the mesh of a surface field stands for its scene.
#pragma once

#include <cstdint>
#include <string>

namespace lumi::baker
{

// What the mesh gets wrong, in shares of the rays that meet the scene.
struct MeshLoss {
    double missed = 0;     // the mesh is not there
    double added = 0;      // the ray meets the mesh, but not the scene
    double displaced = 0;  // the depths differ by more than a twentieth of the radius

    // Known for the mesh of a surface field only:
    bool rough = false;         // simplified without regard to the shape's topology, because nothing else got there
    uint32_t holes = 0;         // regions of more than 2 pixels that its silhouettes lack, 24 of 240 × 240 pixels
    uint32_t largest_hole = 0;  // pixels
};

// A sentence for the user without its full stop: what is wrong with a mesh, and what mends it in the scene.
struct MeshWarning {
    std::string text;
    bool more_triangles_help = false;  // so would settings with more triangles; false where the scene has no more
};

}  // namespace lumi::baker
