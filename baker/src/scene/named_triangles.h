// SPDX-License-Identifier: MIT
// Finds the triangles that have a name.
#pragma once

#include "model/scene_parts.h"

namespace lumi::baker
{

// By triangle: those of the objects, groups or nodes of that name, or else those of the materials of that name. `file`
// serves the message. Throws SceneError if nothing has the name.
std::vector<bool> triangles_named(const std::string& name, const std::string& file, const SceneParts& parts);

}  // namespace lumi::baker
