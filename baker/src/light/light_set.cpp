// SPDX-License-Identifier: MIT
#include "light/light_set.h"

namespace lumi::baker
{

LightSet::LightSet(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures,
                   const Environment& environment, std::vector<Fixture> fixtures, float samples)
    : sky_(environment), emitters_(mesh, materials, textures), fixtures_(std::move(fixtures))
{
    const double sky = static_cast<double>(sky_.power());
    lamps_ = Distribution({static_cast<double>(emitters_.power()), static_cast<double>(fixtures_.power())});
    outside_ = Distribution({sky, static_cast<double>(fixtures_.power())});
    if (const Distribution all({sky, lamps_.total()}); !all.empty()) {
        sky_samples_ = std::min(samples * all.probability(0), 1.0f);
        lamp_samples_ = std::min(samples * all.probability(1), 1.0f);
    }
    takes_two_ = samples > 1 && sky_samples_ > 0 && lamp_samples_ > 0;
    if (!lamps_.empty()) {
        emitter_samples_ = lamp_samples_ * lamps_.probability(kEmitters);
        fixture_samples_ = lamp_samples_ * lamps_.probability(kFixtures);
    }
}

LightSample LightSet::lamp(const Vec3& from, float u_select, const Vec2& u) const
{
    const Distribution::Draw draw = lamps_.draw(u_select);
    LightSample s =
        draw.index == kEmitters ? emitters_.sample(from, draw.rest, u) : fixtures_.sample(from, draw.rest, u);
    s.pdf *= lamps_.probability(draw.index);
    return s;
}

LightSample LightSet::sample_outside(const Vec3& from, float u_light, float u_select, const Vec2& u) const
{
    const size_t kind = outside_.draw(u_light).index;
    LightSample s = kind == kSky ? sky_.sample(from, u_select, u) : fixtures_.sample(from, u_select, u);
    s.pdf *= outside_.probability(kind);
    return s;
}

float LightSet::outside_sky_pdf(const Vec3& direction) const
{
    return sky_.power() > 0 ? outside_.probability(kSky) * sky_.pdf(direction) : 0.0f;
}

float LightSet::sky_pdf(const Vec3& direction) const
{
    return sky_samples_ > 0 ? sky_samples_ * sky_.pdf(direction) : 0.0f;
}

float LightSet::emitter_pdf(uint32_t triangle, const Vec3& direction, float distance) const
{
    return emitter_samples_ > 0 ? emitter_samples_ * emitters_.pdf(triangle, direction, distance) : 0.0f;
}

void LightSet::add_to(Digest& digest) const
{
    sky_.add_to(digest);
    fixtures_.add_to(digest);
}

}  // namespace lumi::baker
