// SPDX-License-Identifier: MIT
// How well the mesh of a surface field stands for its scene.
#pragma once

#include <cstdint>
#include <string>

namespace lumi::baker
{

// What the mesh gets wrong, in shares of the rays that meet the scene.
struct MeshLoss {
    double missed = 0;              // the mesh is not there
    double missed_see_through = 0;  // of that: where see-through parts are
    double added = 0;               // the ray meets the mesh, but not the scene
    double displaced = 0;           // the depths differ by more than a twentieth of the radius

    // Of the scene itself: what is seen is thinner than a pixel at 240 x 240; 0 where light may pass through surfaces.
    double thin = 0;

    // Known for the mesh of a surface field only:
    bool rough = false;         // simplified without regard to the shape's topology, because nothing else got there
    uint32_t holes = 0;         // regions of more than 2 pixels that its silhouettes lack, 24 of 240 × 240 pixels
    uint32_t largest_hole = 0;  // pixels
};

// For the user, each the part of a sentence.
struct MeshWarning {
    std::string problem;
    std::string remedy;  // in the scene, or by another layout; may be empty
    bool more_triangles_help =
        false;  // settings with more triangles are a remedy, too; not where the scene has no more
};

}  // namespace lumi::baker
