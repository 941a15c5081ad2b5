// SPDX-License-Identifier: MIT
// How bright a scene is seen, with grey clay in place of its materials: colours and finishes do not change it.
#pragma once

#include <vector>

#include "geometry/accelerator.h"
#include "light/light_set.h"

namespace lumi::baker
{

// What light falls on, in the frame of the unit sphere; borrowed.
struct LitShape {
    const Mesh& mesh;
    const std::vector<Material>& materials;
    const std::vector<Texture>& textures;
    const Accelerator& accelerator;
};

// The luminance that rays from all around see, a value for each ray that meets a surface, ascending: what is emitted
// there, and what clay sends back of the light that falls there. What lets light pass is left out, as is a volume.
// The same values on every machine. Costs some ten thousand rays.
std::vector<float> meter(const LitShape& shape, const LightSet& lights);

// The median of what is lit: of the values above an eighth of their mean. 0 where nothing is.
float middle_of_lit(const std::vector<float>& metered);

}  // namespace lumi::baker
