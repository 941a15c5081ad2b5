// SPDX-License-Identifier: MIT
#include "proxy/proxy_points.h"

namespace lumi::proxy_math
{
ViewPoint view_point(const ProxyProjection& p, const Triple12& v)
{
    return view_of(p, v);
}

SamplePoint project(const ProxyProjection& p, const ViewPoint& v)
{
    return projected(p, v);
}

SamplePoint project_vertex(const ProxyProjection& p, const Triple12& v)
{
    return projected(p, view_of(p, v));
}

}  // namespace lumi::proxy_math
