// SPDX-License-Identifier: MIT
// What a ProxyCache holds.
#pragma once

#include <map>

#include "proxy/proxy_builder.h"

namespace lumi::baker
{

struct ProxyCache::Contents {
    std::map<uint32_t, BuiltProxy> by_triangles;  // as many as were asked for

    const BuiltProxy& proxy(const SceneData& scene, uint32_t triangles, Job& job)
    {
        const auto found = by_triangles.find(triangles);
        if (found != by_triangles.end()) {
            return found->second;
        }
        return by_triangles.emplace(triangles, build_proxy(scene, triangles, job)).first->second;
    }
};

}  // namespace lumi::baker
