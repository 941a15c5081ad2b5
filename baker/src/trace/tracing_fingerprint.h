// SPDX-License-Identifier: MIT
// Tells whether two bakes would trace the same.
#pragma once

#include "scene/scene_data.h"

namespace lumi::baker
{

// A hash of what some thousand fixed light paths bring home, to the last bit. Where it differs though the scenes are
// the same, the two builds or processors do not compute alike.
uint64_t tracing_fingerprint(const SceneData& scene);

}  // namespace lumi::baker
