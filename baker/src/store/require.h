// SPDX-License-Identifier: MIT
// What settings must hold before a bake begins.
#pragma once

#include <string>

#include "lumi/baker/bake.h"

namespace lumi::baker
{

// Throws BakeError with this message if it is not so.
inline void require(bool good, const std::string& message)
{
    if (!good) throw BakeError(message);
}

}  // namespace lumi::baker
