// SPDX-License-Identifier: MIT
#include "draw/span_stripes.h"

namespace lumi::tools
{

template Picture draw_texels<TexelLuma8>(const Field&, const Camera&, const DrawSettings&);

}  // namespace lumi::tools
