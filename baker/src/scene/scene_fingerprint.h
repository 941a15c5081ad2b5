// SPDX-License-Identifier: MIT
// Tells whether two bakes would trace the same.
#pragma once

#include "scene/scene_data.h"
#include "util/digest.h"

namespace lumi::baker
{

// Of everything that the path tracer reads: triangles, materials, textures, the sphere, and the lights by what they
// send. The same files and options give the same value on every machine and in every version of this program.
// Cost: one pass over the scene.
Digest::Value scene_fingerprint(const SceneData& scene);

// Of what some thousand fixed light paths bring home, to the last bit: differs too where another build or processor
// computes otherwise.
uint64_t tracing_fingerprint(const SceneData& scene);

}  // namespace lumi::baker
