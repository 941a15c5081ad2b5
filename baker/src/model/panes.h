// SPDX-License-Identifier: MIT
// Tells panes from bodies of glass.
#pragma once

#include "model/scene_parts.h"

namespace lumi::baker
{

// Glass of these materials whose triangles are sheets, or enclose nothing, becomes panes: light passes straight,
// coloured once by the transmittance. Other glass gets its colour on its way through. Returns how many are panes now.
size_t make_panes(SceneParts& parts, const std::vector<bool>& wanted);

}  // namespace lumi::baker
