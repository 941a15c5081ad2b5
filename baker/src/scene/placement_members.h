// SPDX-License-Identifier: MIT
// Where a scene file puts an object: its members 'scale', 'rotate' and 'translate'.
#pragma once

#include "scene/placement.h"
#include "util/json_members.h"

namespace lumi::baker
{

// Throws SceneError.
Placement read_placement(JsonMembers& members);

}  // namespace lumi::baker
