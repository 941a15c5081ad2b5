// SPDX-License-Identifier: MIT
// The volume of a scene file.
#pragma once

#include <filesystem>

#include "util/json_members.h"
#include "volume/volume.h"

namespace lumi::baker
{

// Reads the member and the grid that it names. Throws SceneError.
Volume read_volume(const std::filesystem::path& scene_file, const JsonValue& value);

}  // namespace lumi::baker
