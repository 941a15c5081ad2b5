// SPDX-License-Identifier: MIT
// Reads a model of any format that is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// What ends in .glb or .gltf, in any letter case, is read as glTF, and all else as OBJ. Throws SceneError; appends to
// `warnings`.
SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
