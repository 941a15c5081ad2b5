// SPDX-License-Identifier: MIT
// Reads glTF 2.0 files, .gltf or .glb, with their buffers and pictures: tinygltf behind a wall.
#pragma once

#include "model/gltf/model.h"

namespace lumi::baker
{

// Files are found as those of an OBJ (find_beside). Throws SceneError, also for what a file requires and we cannot
// read; appends to `warnings`.
GltfModel read_gltf_file(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
