// SPDX-License-Identifier: MIT
#include "texel_frames.h"

namespace lumi::firmware
{

template bool write_texel_frames<TexelPalette8>(const Frame&);

}  // namespace lumi::firmware
