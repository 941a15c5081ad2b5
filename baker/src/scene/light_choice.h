// SPDX-License-Identifier: MIT
// Sky and exposure of a scene whose files and options leave them open.
//
// The studio lights what has no light of its own: no sky, no lamp, and no material that shines and by itself lights
// most of the scene. An exposure is chosen for what lamps or a picture light, since they may be stated in any unit:
// what is lit then gets a middle tone. Both are functions of the scene alone, so all commands choose alike.
#pragma once

#include <string>

#include "image/tone.h"
#include "scene/light_meter.h"

namespace lumi::baker
{

// In the frame of the unit sphere.
struct StatedLight {
    std::optional<Environment> environment;
    std::vector<Fixture> fixtures;
    std::optional<float> exposure;  // factor on all light
    ToneCurve tone;
};

struct LightChoice {
    Environment environment;
    float exposure = 1;
    std::vector<std::string> notes;  // what was chosen, and the option that decides otherwise; a sentence each
    std::vector<std::string> warnings;
};

LightChoice choose_light(const StatedLight& stated, const LitShape& shape);

}  // namespace lumi::baker
