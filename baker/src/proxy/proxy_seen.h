// SPDX-License-Identifier: MIT
// Which triangles of a proxy can be seen from around.
#pragma once

#include "proxy/proxy_tracer.h"
#include "proxy/view_cap.h"
#include "util/job.h"

namespace lumi::baker
{

// Without the triangles that nobody outside can see: each gets many rays, in many directions, before it counts as
// such. Positions stay as they are.
Mesh seen_part(const ProxyTracer& proxy, Job& job, const ViewCap& cap = {});

}  // namespace lumi::baker
