// SPDX-License-Identifier: MIT
// Proxy meshes of scenes: few triangles near the surface that can be seen from outside.
#pragma once

#include <cstdint>

namespace lumi::baker
{

// What the proxy gets wrong, in shares of the rays that meet the scene.
struct ProxyLoss {
    double missed = 0;     // the proxy is not there
    double added = 0;      // the ray meets the proxy, but not the scene
    double displaced = 0;  // the depths differ by more than a twentieth of the radius

    // Of the mesh of a surface field:
    bool rough = false;         // simplified without regard to the shape's topology, because nothing else got there
    uint32_t holes = 0;         // regions of more than 2 pixels that its silhouettes lack, 24 of 240 × 240 pixels
    uint32_t largest_hole = 0;  // pixels
};

}  // namespace lumi::baker
