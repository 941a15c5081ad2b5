// SPDX-License-Identifier: MIT
#include "material.h"

namespace lumi::baker
{
namespace
{

constexpr float kMaxRadiance = 1e9f;     // sums of many stay finite in binary32
constexpr float kMaxIndex = 4;           // of diamond 2.4, of germanium 4
constexpr float kMinGlassIndex = 1.01f;  // closer to 1, facets and directions can no longer be told apart
constexpr size_t kRoughnessSteps = 64;

Rgb clamped(const Rgb& c, float low, float high)
{
    return {std::clamp(c.r, low, high), std::clamp(c.g, low, high), std::clamp(c.b, low, high)};
}

float clamped_alpha(float alpha)
{
    return std::clamp(alpha, kMinAlpha, 1.0f);
}

// One table for the material's alpha, or with a texture one for each step of roughness up to it.
template <class Table, class Make>
std::vector<std::shared_ptr<const Table>> tables(bool textured, float alpha, const Make& make)
{
    std::vector<std::shared_ptr<const Table>> result;
    for (size_t k = textured ? 0 : kRoughnessSteps; k <= kRoughnessSteps; ++k) {
        const float share = static_cast<float>(k) / kRoughnessSteps;
        result.push_back(std::make_shared<const Table>(make(clamped_alpha(alpha * share * share))));
    }
    return result;
}

template <class Table>
const Table& nearest(const std::vector<std::shared_ptr<const Table>>& list, float roughness)
{
    const float last = static_cast<float>(list.size() - 1);
    return *list[static_cast<size_t>(std::clamp(roughness, 0.0f, 1.0f) * last + 0.5f)];
}

float absorption_of(float transmittance, float distance)
{
    constexpr float kDarkest = 1e-6f;  // black glass is a very dark one
    return -std::log(std::max(transmittance, kDarkest)) / distance;
}

Bsdf coated(const Coated::Body& body, const Material& m)
{
    if (m.coat_skin) {
        return Bsdf(Coated(body, *m.coat_skin, m.coat));
    }
    return std::visit([](const auto& b) { return Bsdf(b); }, body);
}

}  // namespace

void Material::finish()
{
    base = clamped(base, 0, 1);
    emission = clamped(emission, 0, kMaxRadiance);
    metalness = std::clamp(metalness, 0.0f, 1.0f);
    const bool smooth = alpha < kMinAlpha;
    alpha = smooth && glass ? 0 : clamped_alpha(alpha);
    opacity = std::clamp(opacity, 0.0f, 1.0f);
    index = index > 1 ? std::min(index, kMaxIndex) : kDefaultIndex;
    coat = std::clamp(coat, 0.0f, 1.0f);
    coat_alpha = clamped_alpha(coat_alpha);
    skins.clear();
    facets.clear();
    frost = nullptr;
    coat_skin = nullptr;
    if (glass) {
        index = std::max(index, kMinGlassIndex);
        transmittance = clamped(transmittance, 0, 1);
        absorption = {absorption_of(transmittance.r, transmittance_length),
                      absorption_of(transmittance.g, transmittance_length),
                      absorption_of(transmittance.b, transmittance_length)};
        frost = alpha > 0 ? std::make_shared<const GlassTable>(index, alpha) : nullptr;
        return;
    }
    const bool textured = maps.roughness.used();
    if (specular && (metalness < 1 || maps.metalness.used())) {
        skins = tables<Skin>(textured, alpha, [this](float a) { return Skin(index, a); });
    }
    if (metalness > 0) {
        facets = tables<FacetTable>(textured, alpha, [](float a) { return FacetTable(a); });
    }
    coat_skin = coat > 0 ? std::make_shared<const Skin>(kDefaultIndex, coat_alpha) : nullptr;
}

Rgb Material::absorbed(float distance) const
{
    return {std::exp(-absorption.r * distance), std::exp(-absorption.g * distance), std::exp(-absorption.b * distance)};
}

PointValues Material::plain_values() const
{
    return {base, metalness, 1, true};
}

Bsdf Material::bsdf(const PointValues& at, float u) const
{
    if (glass) {
        return frost ? Bsdf(RoughGlass(*frost, at.outside)) : Bsdf(SmoothGlass(at.outside ? index : 1 / index));
    }
    if (u < at.metalness) {
        return coated(Conductor(at.base, nearest(facets, at.roughness)), *this);
    }
    if (!skins.empty()) {
        return coated(Plastic(at.base, nearest(skins, at.roughness)), *this);
    }
    return coated(Diffuse(at.base), *this);
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
