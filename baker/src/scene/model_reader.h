// SPDX-License-Identifier: MIT
// Reads a model of any format that is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// By the end of its name in any letter case, or else by its first bytes: glTF, GLB, or OBJ. Refuses each other format
// by its own name, with the way out. Throws SceneError; appends to `warnings`.
SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
