// SPDX-License-Identifier: MIT
// Text as HTML shows it.
#pragma once

#include <string>
#include <string_view>

#include "image/picture.h"

namespace lumi::quality
{

// With &, <, > and quotes escaped.
std::string escaped(std::string text);

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

// An <img> that holds the picture itself.
std::string image_tag(const tools::Picture& picture, std::string_view alternative_text);

}  // namespace lumi::quality
