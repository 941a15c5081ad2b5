// SPDX-License-Identifier: MIT
// A drawing over a photograph, as a see-through display shows it.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// The same view drawn over black and over white tells each channel's coverage; the photograph shows through the rest.
// Right to one level of 255. Preconditions: all of one size.
Picture over_photo(const Picture& over_black, const Picture& over_white, const Picture& photo);

}  // namespace lumi::tools
