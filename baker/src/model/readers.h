// SPDX-License-Identifier: MIT
// Reads models. Each reader throws SceneError and appends to `warnings`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene_parts.h"

namespace lumi::baker
{

// Reads Wavefront OBJ and its MTL files.
SceneParts read_obj(const std::filesystem::path& file, std::vector<std::string>& warnings,
                    ColourScale colours = ColourScale::unstated);

// Reads glTF 2.0: .gltf with its buffers and pictures, or .glb. Units are metres, up is y. Lamps of
// KHR_lights_punctual become fixtures. Skins, morphs and nodes are posed as the file's nodes are, or at a time.
SceneParts read_gltf(const std::filesystem::path& file, std::vector<std::string>& warnings,
                     const std::optional<AnimationTime>& time = std::nullopt);

// Whether a file that begins like this is PLY.
bool is_ply(std::string_view head);
// Reads PLY, text or binary in both orders of bytes: positions, normals and colours of vertices, and faces. Colours are
// those of a display (sRGB). All else is left out. Refuses points without faces.
SceneParts read_ply(const std::filesystem::path& file, std::vector<std::string>& warnings);

// Whether a file of that many bytes, which begins like this, is STL.
bool is_stl(std::string_view head, size_t file_bytes);
// Reads STL, text or binary. Up is z, as in CAD. Normals of the file do not count, nor do colours: STL has no standard
// for them.
SceneParts read_stl(const std::filesystem::path& file, std::vector<std::string>& warnings);

}  // namespace lumi::baker
