// SPDX-License-Identifier: MIT
// Extensions of glTF 2.0: which ones are drawn, and their members.
#pragma once

#include "model/gltf/model.h"

namespace lumi::baker
{

// Throws SceneError unless it is 2.x.
void check_gltf_version(const GltfModel& model, const std::string& version);

// Throws SceneError that names the first one that is not drawn, and the way out.
void check_required_extensions(const GltfModel& model, const std::vector<std::string>& required);

// Throws SceneError for a texture whose pictures only its extensions name.
void refuse_foreign_pictures(const GltfModel& model, const std::map<std::string, JsonValue>& extensions);

// In binary32, and no larger than that products of two such numbers stay finite.
float float_of(double number);

// A member of an extension, or null. `value` is any value.
const JsonValue* find_member(const JsonValue& value, const char* name);
// Returns a member's value, or `fallback` where it is absent or no finite number.
double number_member(const JsonValue& value, const char* name, double fallback);
Rgb colour_member(const JsonValue& value, const char* name, const Rgb& fallback);

// With KHR_texture_transform. `texture` may be kNoIndex.
GltfTextureUse texture_use_of(const GltfModel& model, int32_t texture, int32_t uv_set,
                              const std::map<std::string, JsonValue>& extensions);
// Reads a member of an extension so; none where it is absent.
GltfTextureUse texture_member(const GltfModel& model, const JsonValue& value, const char* name);

}  // namespace lumi::baker
