// SPDX-License-Identifier: MIT
// An object of a scene file that is a volume's iso-surface: its members 'volume', 'iso', 'pieces' and 'material'.
#pragma once

#include <filesystem>

#include "scene/scene_data.h"
#include "util/json_members.h"

namespace lumi::baker
{

// In the volume's own place. Throws SceneError.
SceneParts read_iso_object(const std::filesystem::path& scene_file, JsonMembers& members);

}  // namespace lumi::baker
