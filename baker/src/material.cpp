// SPDX-License-Identifier: MIT
#include "material.h"

namespace lumi::baker
{
namespace
{

Rgb clamped(const Rgb& c, float low, float high)
{
    return {std::clamp(c.r, low, high), std::clamp(c.g, low, high), std::clamp(c.b, low, high)};
}

}  // namespace

void Material::finish()
{
    constexpr float kMaxRadiance = 1e9f;  // sums of many stay finite in binary32
    base = clamped(base, 0, 1);
    emission = clamped(emission, 0, kMaxRadiance);
    metalness = std::clamp(metalness, 0.0f, 1.0f);
    alpha = std::clamp(alpha, kMinAlpha, 1.0f);
    opacity = std::clamp(opacity, 0.0f, 1.0f);
    index = index > 1 ? index : kDefaultIndex;
    if (specular && metalness < 1) {
        skin = std::make_shared<Skin>(index, alpha);
    }
}

Bsdf Material::bsdf(const Rgb& base_at, float u) const
{
    if (u < metalness) {
        return Bsdf(Conductor(base_at, alpha));
    }
    if (skin) {
        return Bsdf(Plastic(base_at, *skin));
    }
    return Bsdf(Diffuse(base_at));
}

float alpha_from_phong_exponent(float exponent)
{
    return std::sqrt(2 / (std::max(exponent, 0.0f) + 2));
}

float alpha_from_roughness(float roughness)
{
    return roughness * roughness;
}

}  // namespace lumi::baker
