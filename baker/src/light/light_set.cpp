// SPDX-License-Identifier: MIT
#include "light/light_set.h"

namespace lumi::baker
{

LightSet::LightSet(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures,
                   const Environment& environment, std::vector<Fixture> fixtures)
    : sky_(environment), emitters_(mesh, materials, textures), fixtures_(std::move(fixtures))
{
    std::vector<double> powers(3);
    powers[kSky] = static_cast<double>(sky_.power());
    powers[kEmitters] = static_cast<double>(emitters_.power());
    powers[kFixtures] = static_cast<double>(fixtures_.power());
    choice_ = Distribution(powers);
    powers[kEmitters] = 0;
    outside_ = Distribution(powers);
}

LightSample LightSet::sample(const Distribution& choice, const Vec3& from, float u_light, float u_select,
                             const Vec2& u) const
{
    const size_t kind = choice.draw(u_light).index;
    LightSample s = kind == kSky        ? sky_.sample(from, u_select, u)
                    : kind == kEmitters ? emitters_.sample(from, u_select, u)
                                        : fixtures_.sample(from, u_select, u);
    s.pdf *= choice.probability(kind);
    return s;
}

LightSample LightSet::sample(const Vec3& from, float u_light, float u_select, const Vec2& u) const
{
    return sample(choice_, from, u_light, u_select, u);
}

LightSample LightSet::sample_outside(const Vec3& from, float u_light, float u_select, const Vec2& u) const
{
    return sample(outside_, from, u_light, u_select, u);
}

float LightSet::sky_pdf(const Distribution& choice, const Vec3& direction) const
{
    return sky_.power() > 0 ? choice.probability(kSky) * sky_.pdf(direction) : 0.0f;
}

float LightSet::sky_pdf(const Vec3& direction) const
{
    return sky_pdf(choice_, direction);
}

float LightSet::outside_sky_pdf(const Vec3& direction) const
{
    return sky_pdf(outside_, direction);
}

float LightSet::emitter_pdf(uint32_t triangle, const Vec3& direction, float distance) const
{
    return emitters_.power() > 0 ? choice_.probability(kEmitters) * emitters_.pdf(triangle, direction, distance) : 0.0f;
}

void LightSet::add_to(Digest& digest) const
{
    sky_.add_to(digest);
    fixtures_.add_to(digest);
}

}  // namespace lumi::baker
