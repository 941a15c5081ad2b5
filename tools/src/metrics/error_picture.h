// SPDX-License-Identifier: MIT
// Where two pictures differ, as a picture.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// |a - b| per channel times kErrorGain, clamped: black where equal, brighter where worse.
// Precondition: same_size(a, b).
inline constexpr int kErrorGain = 4;
Picture error_picture(const Picture& a, const Picture& b);

}  // namespace lumi::tools
