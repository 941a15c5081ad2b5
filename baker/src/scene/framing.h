// SPDX-License-Identifier: MIT
// One part of a scene fills the sphere, whatever else there is.
#pragma once

#include <filesystem>

#include "model/scene_parts.h"

namespace lumi::baker
{

// Gives the scene the sphere around the objects, groups or nodes of that name, or else around what is of the material
// of that name, and cuts off all else that lies outside of it, along a body of flat sides that the sphere holds.
// `file` serves messages. Throws SceneError if nothing has the name, and where there is a volume.
void frame_part(const std::filesystem::path& file, const std::string& name, SceneParts& parts);

}  // namespace lumi::baker
