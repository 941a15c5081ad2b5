// SPDX-License-Identifier: MIT
// Proxy meshes of scenes: few triangles near the surface that can be seen from outside.
#pragma once

#include <memory>

namespace lumi::baker
{

// What the proxy gets wrong, in shares of the rays that meet the scene.
struct ProxyLoss {
    double missed = 0;     // the proxy is not there
    double added = 0;      // the ray meets the proxy, but not the scene
    double displaced = 0;  // the depths differ by more than a twentieth of the radius
};

// Proxies that several bakes of one scene share: each number of triangles is built once. Not for several threads.
class ProxyCache
{
public:
    ProxyCache();
    ~ProxyCache();
    ProxyCache(const ProxyCache&) = delete;
    ProxyCache& operator=(const ProxyCache&) = delete;

    struct Contents;  // baker's own, see baker/src
    Contents& contents() { return *contents_; }

private:
    std::unique_ptr<Contents> contents_;
};

}  // namespace lumi::baker
