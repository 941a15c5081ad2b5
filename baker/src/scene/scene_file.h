// SPDX-License-Identifier: MIT
// Reads scene files, see docs/scenes.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// Throws SceneError; appends to `warnings`. `up`, if given, counts in place of what the file says. `colours`: of MTL
// files.
SceneParts read_scene_file(const std::filesystem::path& file, std::optional<UpAxis> up,
                           std::vector<std::string>& warnings, ColourScale colours = ColourScale::unstated);

}  // namespace lumi::baker
