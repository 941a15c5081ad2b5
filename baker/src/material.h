// SPDX-License-Identifier: MIT
// What a triangle is made of, and how MTL's terms become it.
//
// MTL                      here
// Pm > 0 or Pr > 0         metalness Pm, alpha = Pr²; specular always
// Kd black, Ks not         a metal of colour Ks
// Ks not black             plastic: a dielectric skin of index Ni (1.5 if Ni <= 1) over Kd; Ks's own colour is not used
// otherwise                Lambert
// Ns                       alpha = √(2/(Ns+2)), the GGX width whose peak falls off like Phong's lobe (Walter et al.,
//                          "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, section 5.2)
// d, 1-Tr                  opacity: the share of light that does not pass straight through
// Ke                       radiance emitted from both sides
// map_Kd                   times Kd
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "bsdf.h"

namespace lumi::baker
{

inline constexpr int32_t kNoTexture = -1;
inline constexpr float kMinAlpha = 0.01f;  // sharper facets than this no field resolves, and binary32 begins to suffer
inline constexpr float kDefaultIndex = 1.5f;

struct Material {
    std::string name;
    Rgb base = grey(0.6f);  // reflectance of the diffuse body, or of the metal at normal incidence; <= 1
    int32_t base_texture = kNoTexture;
    Rgb emission;
    float metalness = 0;
    bool specular = false;  // a dielectric skin where the surface is not metal
    float alpha = 1;        // GGX width
    float index = kDefaultIndex;
    std::shared_ptr<const Skin> skin;  // of a specular surface; made by finish()
    float opacity = 1;

    // Clamps what must be in range and derives what is derived. Call once after filling in.
    void finish();

    bool emits() const { return !is_black(emission); }
    // base_at: base times the texture at the point. A partly metallic surface is metal with probability metalness: u.
    Bsdf bsdf(const Rgb& base_at, float u) const;
};

float alpha_from_phong_exponent(float exponent);
float alpha_from_roughness(float roughness);

}  // namespace lumi::baker
