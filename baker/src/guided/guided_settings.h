// SPDX-License-Identifier: MIT
// Whether a guided field can be what its settings ask for.
#pragma once

#include "lumi/baker/guided.h"
#include "scene/scene_data.h"

namespace lumi::baker
{

// What is left open is filled in: used_origins. Throws BakeError.
GuidedSettings checked(const GuidedSettings& settings);

// The focus in the frame of the unit sphere. Throws BakeError where it reaches out of the sphere.
struct PackedFocus {
    std::array<int16_t, 3> point_q14;
    uint16_t radius_q14;
};
PackedFocus focus_of(const SceneData& scene, const GuidedSettings& settings);

}  // namespace lumi::baker
