// SPDX-License-Identifier: MIT
#pragma once

#include "lumi/baker/surface.h"

namespace lumi::baker
{

// Throws BakeError for settings that no field can hold.
void require_possible_surface(const SurfaceSettings& settings);

}  // namespace lumi::baker
