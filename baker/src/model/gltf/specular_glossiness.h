// SPDX-License-Identifier: MIT
// Turns colours of KHR_materials_pbrSpecularGlossiness into a base colour and a share of metal.
//
// A surface of diffuse colour d and specular colour s is metal by the share m, with the base colour b, where what both
// models mix agrees: d (1 - max s) = b (1 - m)(1 - f0) and s = f0 (1 - m) + b m, in brightness. That is a quadratic
// equation of m, as in the extension's appendix "Best Practices".
#pragma once

#include "image/texture.h"

namespace lumi::baker
{

struct Metallic {
    Rgb base = grey(1);
    float metalness = 0;
};

// `f0`: what the dielectric reflects from straight above.
Metallic metallic_of(const Rgb& diffuse, const Rgb& specular, float f0);

// A factor, and a picture of colours or null.
struct FactoredPicture {
    const Texture* picture;
    Rgb factor;
};

struct MetallicPictures {
    float f0 = 0.04f;                 // of the dielectric
    bool is_metal_somewhere = false;  // if not, the diffuse colour is the base colour
    Metallic plain;                   // without any picture
    Texture base, metalness;          // with one: of base colours, factors included
};

MetallicPictures metallic_pictures(const FactoredPicture& diffuse, const FactoredPicture& specular);

// Makes it from a picture that has glossiness in all channels.
Texture roughness_picture(Texture glossiness, float factor);

}  // namespace lumi::baker
