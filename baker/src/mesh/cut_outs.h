// SPDX-License-Identifier: MIT
// Cuts a scene's triangles along their pictures of opacity (map_d).
#pragma once

#include <optional>

#include "scene/scene_data.h"

namespace lumi::baker
{

// The scene's triangles, those with such a picture cut along the line where it lets half of the light pass, to about a
// pixel at 240 × 240. Only positions and corners count; pieces of different triangles do not share vertices. Nothing
// where no picture cuts anything.
std::optional<Mesh> cut_out(const SceneData& scene);

// By material: about how long the lines are along which its picture would cut, in radii.
std::vector<float> cut_lengths(const SceneData& scene);

}  // namespace lumi::baker
