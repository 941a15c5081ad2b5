// SPDX-License-Identifier: MIT
// Tells whether two bakes would trace the same.
#pragma once

#include "scene/scene_data.h"

namespace lumi::baker
{

// Of what some thousand fixed light paths bring home, to the last bit: where it differs though the scenes are the same,
// another build or processor computes otherwise.
uint64_t tracing_fingerprint(const SceneData& scene);

}  // namespace lumi::baker
