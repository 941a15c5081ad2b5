// SPDX-License-Identifier: MIT
// Groups of a scene's lights, the states of a field: the weight of each is chosen when it is drawn.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene_data.h"

namespace lumi::baker
{

// Makes states of what a scene file labels, and of the lights that the caller names. `file` serves messages. Throws
// SceneError where a name has no light, and for more states than a field holds.
void set_light_states(const std::filesystem::path& file, const std::vector<StateOption>& options, SceneParts& parts);

// Gives materials these base colours, and makes states of those whose base colour is chosen later. Throws SceneError
// likewise, and where there are states of lights, too.
void set_tints(const std::filesystem::path& file, const LoadOptions& options, SceneParts& parts);

// The scene with these weights of linear light, one for each of its states.
std::unique_ptr<SceneData> lit_by(const SceneData& scene, const std::vector<Rgb>& weights);

// A state alone.
struct LitState {
    std::string name;
    Scene scene;           // its light is divided by `scale`
    float scale;           // 1, and more where what shines would clip: a multiple of 1/16
    Rgb usual = grey(1);   // its weight until another is chosen
    bool is_tint = false;  // its light is what is left after that of the first state is taken away
};
// About how many levels at full weight one level of a state's own is.
float times_seen(float scale);
// Those that have any light, or all if that would leave one: a field has two at least. Empty: the scene has no states.
std::vector<LitState> lit_states(const SceneData& scene);

}  // namespace lumi::baker
