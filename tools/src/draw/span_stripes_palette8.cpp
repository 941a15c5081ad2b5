// SPDX-License-Identifier: MIT
#include "draw/span_stripes.h"

namespace lumi::tools
{

template Picture draw_texels<TexelPalette8>(const Field&, const Camera&, const DrawSettings&);

}  // namespace lumi::tools
