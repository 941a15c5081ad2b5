// SPDX-License-Identifier: MIT
// Reads a model of any format that is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// What a file holds counts before its name's end: glTF, PLY, STL, or else OBJ. Throws SceneError, which names other
// formats; appends to `warnings`.
SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings,
                      ColourScale colours = ColourScale::unstated);

}  // namespace lumi::baker
