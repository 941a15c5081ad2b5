// SPDX-License-Identifier: MIT
// Proxy meshes of scenes: few triangles near the surface that can be seen from outside.
#pragma once

namespace lumi::baker
{

// What the proxy gets wrong, in shares of the rays that meet the scene.
struct ProxyLoss {
    double missed = 0;     // the proxy is not there
    double added = 0;      // the ray meets the proxy, but not the scene
    double displaced = 0;  // the depths differ by more than a twentieth of the radius
};

}  // namespace lumi::baker
