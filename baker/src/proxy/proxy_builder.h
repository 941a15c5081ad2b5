// SPDX-License-Identifier: MIT
// From a scene to the proxy mesh of a guided field.
#pragma once

#include "lumi/baker/proxy.h"
#include "proxy/packed_proxy.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker
{

struct BuiltProxy {
    PackedProxy proxy;
    ProxyLoss loss;
};

// About `triangles` of them, as many as the format holds at most; none where nothing can be seen.
BuiltProxy build_proxy(const SceneData& scene, uint32_t triangles, Job& job);

// To steps of 1/2048; vertices that fall together are one, triangles without area go.
PackedProxy packed(const Mesh& mesh, bool two_sided);

}  // namespace lumi::baker
