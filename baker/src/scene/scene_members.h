// SPDX-License-Identifier: MIT
// Parts of a scene file. All functions throw SceneError.
#pragma once

#include "light/fixtures.h"
#include "lumi/baker/scene.h"
#include "material/material.h"
#include "util/json_text.h"
#include "volume/volume.h"

namespace lumi::baker
{

// Ranges of numbers that several readers of scene files share.

inline constexpr NumberRange kPlace = {-1e15, 1e15};  // scene units
inline constexpr NumberRange kLength = {1e-9, 1e15};  // scene units
inline constexpr NumberRange kAngle = {-360, 360};    // degrees
inline constexpr NumberRange kShare = {0, 1};
inline constexpr NumberRange kScalar = {-1e30, 1e30};  // values of a volume's grid

// On top of what MTL says of a material: changes the members that `value` names and finishes it anew.
void apply_material_members(const std::string& file, const JsonValue& value, Material& material);

// Sets the label of a light state that a light, a sky or a material has, as member "state".
void take_state(JsonMembers& members, std::string& state);
// `up` is the scene's vertical axis.
Fixture read_fixture(const std::string& file, const JsonValue& value, UpAxis up, std::string& state);
Environment read_environment(const std::filesystem::path& file, JsonMembers& scene, const JsonValue& value,
                             std::vector<std::string>& warnings, std::string& state);

// Reads the member and the grid that it names.
Volume read_volume(const std::filesystem::path& scene_file, const JsonValue& value);

}  // namespace lumi::baker
