// SPDX-License-Identifier: MIT
// Environment and extra lights of a scene file.
#pragma once

#include <filesystem>

#include "light/fixtures.h"
#include "lumi/baker/scene.h"
#include "util/json_members.h"

namespace lumi::baker
{

// All throw SceneError. `up` is the scene's vertical axis.
Fixture read_fixture(const std::string& file, const JsonValue& value, UpAxis up);
Environment read_environment(const std::filesystem::path& file, JsonMembers& scene, const JsonValue& value,
                             std::vector<std::string>& warnings);

}  // namespace lumi::baker
