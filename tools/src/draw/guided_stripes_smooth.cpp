// SPDX-License-Identifier: MIT
// Proxies with four samples a pixel.
#include "draw/guided_stripes.h"
#include "lumi/proxy/proxy_surface.h"

namespace lumi::tools
{

template Picture draw_stripes(const GuidedField&, const Camera&, ProxySurface<4>&, GuidedMode, const Rgb8&);

}  // namespace lumi::tools
