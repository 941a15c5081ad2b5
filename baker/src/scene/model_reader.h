// SPDX-License-Identifier: MIT
// Reads a model of any format that is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// How a model is read where its file leaves that open.
struct ModelOptions {
    ColourScale colours = ColourScale::unstated;            // of MTL
    std::optional<AnimationTime> animation = std::nullopt;  // of glTF
};

// The content of a file counts before its name's end: glTF, PLY, STL, or else OBJ. Throws SceneError, which names other
// formats; appends to `warnings`.
SceneParts read_model(const std::filesystem::path& file, std::vector<std::string>& warnings,
                      const ModelOptions& options = {});

// Makes a volume's iso-surface a scene, in the file's units, z up, with smooth normals; one material, dull as bone,
// named "iso". Throws SceneError, also if the surface is empty.
SceneParts read_iso_surface(const std::filesystem::path& file, const IsoSurface& surface);

// The smallest and the largest value of the file: "-1024 to 3071". Throws SceneError.
std::string range_of_volume(const std::filesystem::path& file);

}  // namespace lumi::baker
