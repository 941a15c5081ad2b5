// SPDX-License-Identifier: MIT
#pragma once

#include "lumi/proxy/proxy_frame.h"

namespace lumi::proxy_math
{

// Sets projection, depths and rays of `out`, whose samples are set; false if the mesh lies behind the near plane.
bool set_projection(const ProxyMesh& mesh, const GuidedCamera& camera, ProxyFrame& out);

// How far before the far end of the range a depth of the buffer lies, Q13. Relative error 2^-14.
int32_t exact_back_q13(const ProxyDepths& depths, int32_t depth);

}  // namespace lumi::proxy_math
