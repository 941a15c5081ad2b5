// SPDX-License-Identifier: MIT
// Reads PLY files: text, and binary in both orders of bytes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// Whether a file that begins like this is PLY.
bool is_ply(std::string_view head);

// Positions, normals and colours of vertices, and faces; colours are those of a display (sRGB). All else is left out.
// Throws SceneError, also for points without faces; appends to `warnings`.
SceneParts read_ply(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
