// SPDX-License-Identifier: MIT
// Reads glTF 2.0 files: .gltf with its buffers and pictures, or .glb.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// In metres, y up. Lamps of KHR_lights_punctual become fixtures. Throws SceneError; appends to `warnings`.
SceneParts read_gltf(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
