// SPDX-License-Identifier: MIT
// Sky and exposure of a scene whose files and options leave them open.
//
// The studio lights what has no light of its own: no sky, no lamp, and no material that shines and by itself lights
// most of the scene, so that most of what does not shine is seen. An exposure is chosen for what lamps or a picture
// light, since they may be stated in any unit: what is lit then gets a middle tone. Both are functions of the scene
// alone, so all commands choose alike.
#pragma once

#include <string>
#include <vector>

#include "geometry/accelerator.h"
#include "image/tone.h"
#include "light/light_set.h"

namespace lumi::baker
{

// How bright a scene is seen, with grey clay in place of its materials: colours and finishes do not change it.

// The surface that light falls on, in the frame of the unit sphere; borrowed.
struct LitShape {
    const Mesh& mesh;
    const std::vector<Material>& materials;
    const std::vector<Texture>& textures;
    const Accelerator& accelerator;
};

// The luminance that rays from all around see, a value for each ray that meets a surface, ascending: what is emitted
// there, and what clay sends back of the light that falls there. What lets light pass is left out, as is a volume.
// Gives the same values on every machine. Costs some ten thousand rays. `what`: all of that, or only surfaces that do
// not shine themselves.
enum class Metered : uint8_t { all, lit_only };
std::vector<float> meter(const LitShape& shape, const LightSet& lights, Metered what = Metered::all);

// The median of what is lit: of the values above an eighth of their mean. 0 where nothing is.
float middle_of_lit(const std::vector<float>& metered);

// Places are in the frame of the unit sphere.
struct StatedLight {
    std::optional<Environment> environment;
    std::vector<Fixture> fixtures;
    std::optional<float> exposure;  // factor on all light
    ToneCurve tone;
};

struct LightChoice {
    Environment environment;
    float exposure = 1;
    std::vector<std::string> notes;  // each says what was chosen, and the option that decides otherwise
    std::vector<std::string> warnings;
};

LightChoice choose_light(const StatedLight& stated, const LitShape& shape);

}  // namespace lumi::baker
