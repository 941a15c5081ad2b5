// SPDX-License-Identifier: MIT
#include "light/light_set.h"

#include "material/texture_slot.h"
#include "math/warp.h"

namespace lumi::baker
{

Rgb emission_at(const Mesh& mesh, const Material& material, const std::vector<Texture>& textures, uint32_t triangle,
                const Vec2& barycentric)
{
    return material.emission * slot_colour(mesh, textures, material.maps.emission, triangle, barycentric);
}

Emitters::Emitters(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures)
    : mesh_(mesh), materials_(materials), textures_(textures)
{
    std::vector<double> powers;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (materials[mesh.materials[t]].emits()) {
            triangles_.push_back(static_cast<uint32_t>(t));
            brightness_.push_back(mean_brightness(triangles_.back()));
            powers.push_back(static_cast<double>(mesh.area(t)) * static_cast<double>(brightness_.back()));
        }
    }
    choice_ = Distribution(powers);
}

// A texture may be black where it is looked at and bright elsewhere: no triangle that may emit is left out.
float Emitters::mean_brightness(uint32_t triangle) const
{
    constexpr float kLeastShare = 0.05f;
    constexpr int kSide = 4;
    const Material& m = material(triangle);
    const float full = max_component(m.emission);
    if (!m.maps.emission.used()) return full;
    float sum = 0;
    for (int k = 0; k < kSide * kSide; ++k) {
        const Vec2 u = {(static_cast<float>(k % kSide) + 0.5f) / kSide, (static_cast<float>(k / kSide) + 0.5f) / kSide};
        sum += max_component(emission_at(mesh_, m, textures_, triangle, square_to_triangle(u)));
    }
    return std::max(sum / (kSide * kSide), full * kLeastShare);
}

float Emitters::brightness(uint32_t triangle) const
{
    const Material& m = material(triangle);
    if (!m.maps.emission.used()) return max_component(m.emission);
    const auto found = std::lower_bound(triangles_.begin(), triangles_.end(), triangle);
    return brightness_[static_cast<size_t>(found - triangles_.begin())];
}

float Emitters::power() const
{
    return static_cast<float>(choice_.total()) * 2 * kPi;
}

float Emitters::pdf(uint32_t triangle, const Vec3& direction, float distance) const
{
    const Vec3 normal = normalized(mesh_.area_vector(triangle));
    const float cosine = std::abs(dot(normal, direction));
    const float per_area = brightness(triangle) / static_cast<float>(choice_.total());
    return cosine > 0 ? per_area * distance * distance / cosine : 0.0f;
}

LightSample Emitters::sample(const Vec3& from, float u_select, const Vec2& u) const
{
    const uint32_t triangle = triangles_[choice_.draw(u_select).index];
    const Vec2 b = square_to_triangle(u);
    const Vec3 point = mesh_.position(triangle, 0) * (1 - b.x - b.y) + mesh_.position(triangle, 1) * b.x +
                       mesh_.position(triangle, 2) * b.y;
    const Vec3 towards = point - from;
    const float distance = length(towards);
    if (!(distance > 0)) return {};
    const Vec3 direction = towards / distance;
    return {direction, distance, emission_at(mesh_, material(triangle), textures_, triangle, b),
            pdf(triangle, direction, distance)};
}

LightSet::LightSet(const Mesh& mesh, const std::vector<Material>& materials, const std::vector<Texture>& textures,
                   const Environment& environment, std::vector<Fixture> fixtures, float samples)
    : sky_(environment), emitters_(mesh, materials, textures), fixtures_(std::move(fixtures))
{
    const double sky = static_cast<double>(sky_.power());
    lamps_ = Distribution({static_cast<double>(emitters_.power()), static_cast<double>(fixtures_.power())});
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

SkyLight LightSet::sky(const Vec3& direction) const
{
    if (!(sky_samples_ > 0)) return {};
    SkyLight light = sky_.at(direction);
    light.pdf *= sky_samples_;
    return light;
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
