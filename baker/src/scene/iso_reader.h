// SPDX-License-Identifier: MIT
// A volume's iso-surface as a scene.
#pragma once

#include <filesystem>

#include "model/scene_parts.h"

namespace lumi::baker
{

// In the file's units, z up, with smooth normals; one material, dull as bone, named "iso". Throws SceneError, also if
// the surface is empty.
SceneParts read_iso_surface(const std::filesystem::path& file, const IsoSurface& surface);

// The smallest and the largest value of the file: "-1024 to 3071". Throws SceneError.
std::string range_of_volume(const std::filesystem::path& file);

}  // namespace lumi::baker
