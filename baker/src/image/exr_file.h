// SPDX-License-Identifier: MIT
// Reads OpenEXR pictures.
#pragma once

#include "image/radiance_picture.h"

namespace lumi::baker
{

bool is_exr(const std::string& bytes);

// The channels R, G, B, or Y as grey, of the first part. Throws PictureError.
RadiancePicture decode_exr(const std::string& bytes);

}  // namespace lumi::baker
