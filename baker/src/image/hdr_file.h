// SPDX-License-Identifier: MIT
// Reads Radiance .hdr pictures: G. Ward, "Real Pixels", Graphics Gems II, 1991.
#pragma once

#include <string>

#include "image/radiance_picture.h"

namespace lumi::baker
{

bool is_hdr(const std::string& bytes);

// RGBE, top row first, flat or with run lengths of each channel. Throws PictureError.
RadiancePicture decode_hdr(const std::string& bytes);

}  // namespace lumi::baker
