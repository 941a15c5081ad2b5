// SPDX-License-Identifier: MIT
// Reads Wavefront OBJ and MTL files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// Throws SceneError; appends to `warnings`.
SceneParts read_obj(const std::filesystem::path& file, std::vector<std::string>& warnings,
                    ColourScale colours = ColourScale::unstated);

}  // namespace lumi::baker
