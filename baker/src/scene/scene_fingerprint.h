// SPDX-License-Identifier: MIT
// Tells whether two scenes are the same.
#pragma once

#include "scene/scene_data.h"
#include "util/digest.h"

namespace lumi::baker
{

// A hash of all that the path tracer reads: triangles, materials, textures, the sphere, and the lights by what they
// send. The same files and options give the same value on every machine and in every version of this program.
// Cost: one pass over the scene.
Digest::Value scene_fingerprint(const SceneData& scene);

}  // namespace lumi::baker
