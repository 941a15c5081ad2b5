// SPDX-License-Identifier: MIT
// What a proxy gets wrong.
#pragma once

#include "lumi/baker/proxy.h"
#include "proxy/proxy_survey.h"

namespace lumi::baker
{

ProxyLoss loss_of(const SceneData& scene, const ProxyTracer& proxy, Job& job, const ViewCap& cap = {});

}  // namespace lumi::baker
