// SPDX-License-Identifier: MIT
// Reads PNG pictures.
#pragma once

#include <string>

#include "lumi/baker/picture_file.h"

namespace lumi::baker
{

bool is_png(const std::string& bytes);

// Any PNG. Checksums count: what is damaged or cut short is refused. Throws PictureError.
DecodedPicture decode_png(const std::string& bytes, bool with_alpha);

}  // namespace lumi::baker
