// SPDX-License-Identifier: MIT
// What a scene file says about materials, on top of their MTL.
#pragma once

#include "material/material.h"
#include "util/json_members.h"

namespace lumi::baker
{

// Changes the members that `value` names and finishes the material anew. Throws SceneError.
void apply_material_members(const std::string& file, const JsonValue& value, Material& material);

}  // namespace lumi::baker
