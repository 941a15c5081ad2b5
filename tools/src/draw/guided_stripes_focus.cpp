// SPDX-License-Identifier: MIT
// Focus surfaces.
#include "draw/guided_stripes.h"
#include "lumi/guided/focus_surface.h"

namespace lumi::tools
{

template Picture draw_stripes(const GuidedField&, const Camera&, FocusSurface&, GuidedMode, const Rgb8&);

}  // namespace lumi::tools
