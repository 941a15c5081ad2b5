// SPDX-License-Identifier: MIT
// Reads JPEG pictures.
#pragma once

#include <string>

#include "lumi/baker/picture_file.h"

namespace lumi::baker
{

bool is_jpeg(const std::string& bytes);

}  // namespace lumi::baker
