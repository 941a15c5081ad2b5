// SPDX-License-Identifier: MIT
// Reads STL files, text or binary.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// Whether a file of that many bytes, which begins like this, is STL.
bool is_stl(std::string_view head, size_t file_bytes);

// Up is z, as in CAD. Normals of the file do not count, nor do colours: STL has no standard for them. Throws
// SceneError; appends to `warnings`.
SceneParts read_stl(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
