// SPDX-License-Identifier: MIT
#include "trace/path_tracer.h"

#include "lumi/baker/bake.h"
#include "lumi/detail/lattice.h"
#include "material/lobes.h"
#include "math/vec3.h"
#include "math/warp.h"
#include "trace/error_gauge.h"
#include "trace/hit_point.h"
#include "util/digest.h"

namespace lumi::baker
{

namespace
{

constexpr int kRouletteAfter = 2;       // bounces on other things than glass that every path makes
constexpr float kWorthTwoRays = 0.03f;  // as a share of the light of white: less is looked for by chance
constexpr float kMaxSurvival = 0.95f;   // even a white path ends some time; out of a medium it finds by itself

// A path on its way: how much of what it finds next arrives at the eye, and how likely its direction was.
struct Walk {
    Ray ray;
    Rgb throughput = grey(1);
    float pdf = 0;             // solid angle, of the last scattering; unused at the eye
    Rgb matt_share = grey(1);  // of what it finds next: PathResult::matt
    bool at_eye = true;
    const Material* glass = nullptr;  // the ray runs through it
    float index2 = 1;                 // the square of its refractive index: radiance in it is larger by as much
    int surfaces = 0;                 // that have turned it
    int bounces = 0;                  // the same, other things than glass
    int scatterings = 0;              // in the medium
};

Rgb emitted(const SceneData& scene, const Walk& walk, const HitPoint& point)
{
    if (!point.material->emits()) return {};
    const Rgb light = walk.throughput * point.emission;
    if (walk.at_eye) return light;
    const float other = scene.lights.emitter_pdf(point.hit.triangle, walk.ray.direction, point.hit.distance);
    return light * power_weight(walk.pdf, other);
}

Rgb from_sky(const SceneData& scene, const Walk& walk)
{
    const SkyLight sky = scene.lights.sky(walk.ray.direction);
    return walk.throughput * sky.radiance * power_weight(walk.pdf, sky.pdf);
}

// Light of the extra lights that the ray passes on its way to `end`.
Rgb from_fixtures(const SceneData& scene, const Walk& walk, float end)
{
    Rgb sum;
    scene.lights.for_each_seen({walk.ray.origin, walk.ray.direction, end}, [&](const Rgb& radiance, float pdf) {
        sum = sum + walk.throughput * radiance * power_weight(walk.pdf, pdf);
    });
    return sum;
}

// A direction must lie on the same side of the shading normal and of the face itself.
bool leaks(const HitPoint& point, const Vec3& direction, const Vec3& local)
{
    return (dot(direction, point.geometric_normal) > 0) != (local.z > 0);
}

// The surface's value and density of a direction. Where it folds, that of the mirror direction below is added, so that
// no light is lost.
struct Scattering {
    Rgb value;
    float pdf;
};

Scattering scattering(const HitPoint& point, const Bsdf& bsdf, const Vec3& wo, const Vec3& direction, const Vec3& wi)
{
    Scattering result = {bsdf.eval(wo, wi), bsdf.pdf(wo, wi)};
    if (!point.folds) return result;
    const Vec3 below = point.frame.to_local(point.mirrored_up(direction));
    return {result.value + bsdf.eval(wo, below), result.pdf + bsdf.pdf(wo, below)};
}

// Draws a number, or only passes over it where nobody looks at it.
float needed_1d(bool needed, Sampler& sampler)
{
    if (needed) return sampler.next_1d();
    sampler.skip_1d();
    return 0;
}

// A surface as it scatters, and the albedo of its diffuse body; black where that is not the same for all directions.
struct Scatterer {
    Bsdf bsdf;
    Rgb matt;
};

Scatterer scatterer_at(const HitPoint& point, Sampler& sampler)
{
    const float metalness = point.values.metalness;
    const bool undecided = (metalness > 0 || (point.material->glass && point.values.transmission < 1)) && metalness < 1;
    const float u = needed_1d(undecided, sampler);
    const bool has_body = !point.material->glass && !point.folds && u >= metalness;
    return {point.material->bsdf(point.values, u), has_body ? point.material->body(point.values, u) : Rgb()};
}

// Light that leaves a surface, and what would leave one that has its diffuse body alone, without a skin.
struct Scattered {
    Rgb all, matt;
};

// The light that would arrive at the eye by the surface if nothing stood in its way.
Scattered unshadowed(const Walk& walk, const HitPoint& point, const Scatterer& at, const Vec3& wo,
                     const LightSample& light)
{
    const Vec3 wi = point.frame.to_local(light.direction);
    const bool is_lost =
        point.folds ? dot(light.direction, point.geometric_normal) <= 0 : leaks(point, light.direction, wi);
    if (!(light.pdf > 0) || is_lost) return {};
    const Scattering s = scattering(point, at.bsdf, wo, light.direction, wi);
    const Rgb arriving = walk.throughput * light.radiance, scattered = arriving * s.value;
    if (is_black(scattered)) return {};
    const float weight = (light.dirac ? 1 : power_weight(light.pdf, s.pdf)) / light.pdf;
    return {scattered * weight, arriving * at.matt * (weight * cosine_pdf(wi))};
}

LightNumbers light_numbers(Sampler& sampler)
{
    const Vec2 choice = sampler.next_2d();
    return {choice, sampler.next_2d()};
}

// Light that arrives at the surface straight from lights and is scattered towards the eye.
Scattered direct_light(const SceneData& scene, const Walk& walk, const HitPoint& point, const Scatterer& at,
                       const Vec3& wo, Sampler& sampler)
{
    Scattered sum;
    if (scene.lights.empty()) return sum;
    const float worth = scene.lights.takes_two() ? kWorthTwoRays : 0;
    scene.lights.sample(point.position, light_numbers(sampler), [&](const LightSample& light, float u) {
        const Scattered most = unshadowed(walk, point, at, wo, light);
        if (is_black(most.all)) return;
        const float brightness = max_component(most.all) * walk.index2;
        const float chance = brightness < worth ? brightness / worth : 1;
        if (u > chance) return;
        const Ray ray = point.ray_to_light(light.direction, light.distance);
        const Rgb through = transmittance(scene, ray, sampler);
        const Rgb share = {through.r / chance, through.g / chance, through.b / chance};
        sum = {sum.all + most.all * share, sum.matt + most.matt * share};
    });
    return sum;
}

// Takes the walk through a boundary of glass. Bodies of glass neither overlap nor lie in each other.
void cross(Walk& walk, const HitPoint& point)
{
    const bool enters = point.values.outside;
    walk.throughput = walk.throughput * point.values.tint;
    walk.glass = enters ? point.material : nullptr;
    walk.index2 = enters ? point.material->index * point.material->index : 1;
}

float ratio(float a, float b)
{
    return b > 0 ? a / b : 0;
}

// Turns the walk at the surface; false where the light is lost.
bool scatter(Walk& walk, const HitPoint& point, const Scatterer& at, const Vec3& wo, float u_lobe, const Vec2& u)
{
    const std::optional<BsdfSample> sample = at.bsdf.sample(wo, u_lobe, u);
    if (!sample) return false;
    Vec3 direction = normalized(point.frame.to_world(sample->wi));
    Rgb weight = sample->weight;
    walk.pdf = sample->pdf;
    if (point.folds) {
        if (dot(direction, point.geometric_normal) < 0) direction = point.mirrored_up(direction);
        const Scattering s = scattering(point, at.bsdf, wo, direction, point.frame.to_local(direction));
        weight = s.value * (1 / s.pdf);
        walk.pdf = s.pdf;
    } else if (leaks(point, direction, sample->wi)) {
        return false;
    }
    if (sample->wi.z < 0) cross(walk, point);
    if (walk.at_eye) {
        const Rgb matt = at.matt * (cosine_pdf(sample->wi) / walk.pdf);
        walk.matt_share = {ratio(matt.r, weight.r), ratio(matt.g, weight.g), ratio(matt.b, weight.b)};
    }
    walk.throughput = walk.throughput * weight;
    walk.ray = point.ray_towards(direction);
    walk.at_eye = false;
    return !is_black(walk.throughput);
}

// Russian roulette: ends dim paths early and makes the survivors carry their share.
bool survives_roulette(Walk& walk, float most, Sampler& sampler)
{
    const float survival = std::min(max_component(walk.throughput) * walk.index2, most);
    if (sampler.next_1d() >= survival) return false;
    walk.throughput = walk.throughput * (1 / survival);
    return true;
}

// Light that arrives at a point of the medium straight from a light and is scattered back along `way`.
Rgb light_in_medium(const SceneData& scene, const Vec3& position, const Vec3& way, Sampler& sampler)
{
    Rgb sum;
    if (scene.lights.empty()) return sum;
    scene.lights.sample(position, light_numbers(sampler), [&](const LightSample& light, float) {
        if (!(light.pdf > 0) || is_black(light.radiance)) return;
        const float scattered = scene.medium->phase().density(dot(way, light.direction));
        const Rgb through = transmittance(scene, ray_to_light(position, light.direction, light.distance), sampler);
        const float weight = light.dirac ? 1 : power_weight(light.pdf, scattered);
        const auto share = [&](float passes) { return scattered * passes * weight / light.pdf; };
        sum = sum + light.radiance * Rgb{share(through.r), share(through.g), share(through.b)};
    });
    return sum;
}

// Adds the light that the medium scatters at this distance, and turns the walk there; false where it ends.
bool scatter_in_medium(const SceneData& scene, Walk& walk, float distance, Rgb& radiance, Sampler& sampler)
{
    const Vec3 position = walk.ray.origin + walk.ray.direction * distance;
    walk.throughput = walk.throughput * scene.medium->colour(position);
    if (walk.at_eye) walk.matt_share = {};
    if (walk.glass) walk.throughput = walk.throughput * walk.glass->absorbed(distance);
    if (is_black(walk.throughput)) return false;
    radiance = radiance + walk.throughput * light_in_medium(scene, position, walk.ray.direction, sampler);
    const Phase& phase = scene.medium->phase();
    const Vec3 way = normalized(phase.sample(walk.ray.direction, sampler.next_2d()));
    walk.pdf = phase.density(dot(walk.ray.direction, way));
    walk.ray = {position, way};
    walk.at_eye = false;
    return ++walk.scatterings < kMaxScatterings &&
           (walk.scatterings <= kRouletteAfter || survives_roulette(walk, 1, sampler));
}

// How far the ray gets in the medium, at most to `end`.
float free_way(const Medium& medium, const Ray& ray, float end, Sampler& sampler)
{
    return medium.collision({ray.origin, ray.direction, end}, sampler).value_or(end);
}

// A path from the eye. It goes on twice from a first surface that has a skin, by the skin and by what lies below: few
// paths would find the skin's light by chance.
class Path
{
public:
    Path(const SceneData& scene, Sampler& sampler) : scene_(scene), sampler_(sampler) {}

    PathResult traced(const Ray& ray)
    {
        follow(Walk{ray});
        return result_;
    }

private:
    void follow(Walk walk)
    {
        while (goes_on(walk)) {
        }
    }

    void add(const Walk& walk, const Rgb& light)
    {
        result_.radiance = result_.radiance + light;
        result_.matt = result_.matt + walk.matt_share * light;
    }

    // Takes the walk to its next surface or scattering, and turns it there; false where it ends.
    bool goes_on(Walk& walk)
    {
        Rgb through = grey(1);
        const std::optional<Hit> hit = closest_opaque(scene_, walk.ray, sampler_, through);
        const float end = hit ? hit->distance : walk.ray.end;
        const float way = scene_.medium ? free_way(*scene_.medium, walk.ray, end, sampler_) : end;
        if (!walk.at_eye) add(walk, from_fixtures(scene_, walk, way));
        walk.throughput = walk.throughput * through;
        if (way < end) {
            result_.covered = true;
            return scatter_in_medium(scene_, walk, way, result_.radiance, sampler_);
        }
        if (!hit) {
            if (!walk.at_eye) add(walk, from_sky(scene_, walk));
            return false;
        }
        result_.covered = true;
        if (walk.glass) walk.throughput = walk.throughput * walk.glass->absorbed(way);
        const HitPoint point = hit_point_at(scene_, walk.ray, *hit);
        if (point.material->thin) walk.throughput = walk.throughput * weight_of_stop(scene_, *hit);
        add(walk, emitted(scene_, walk, point));
        const Vec3 wo = point.frame.to_local(-walk.ray.direction);
        return wo.z > 0 && turns(walk, point, wo);
    }

    bool turns(Walk& walk, const HitPoint& point, const Vec3& wo)
    {
        const Scatterer at = scatterer_at(point, sampler_);
        const Scattered direct = direct_light(scene_, walk, point, at, wo, sampler_);
        result_.radiance = result_.radiance + direct.all;
        result_.matt = result_.matt + (walk.at_eye ? direct.matt : walk.matt_share * direct.all);
        const float u_lobe = needed_1d(at.bsdf.has_lobes(), sampler_);
        const Vec2 u = sampler_.next_2d();
        const float skin = walk.at_eye ? at.bsdf.skin_probability(wo) : 0;
        if (skin > 0) {
            Walk other = walk;
            other.throughput = other.throughput * skin;
            if (scatter(other, point, at, wo, u_lobe * skin, sampler_.next_2d()) && survives(other, at)) follow(other);
            walk.throughput = walk.throughput * (1 - skin);
        }
        return scatter(walk, point, at, wo, skin + u_lobe * (1 - skin), u) && survives(walk, at);
    }

    // Light that shines through glass is only found by paths that go on: glass ends none.
    bool survives(Walk& walk, const Scatterer& at)
    {
        if (++walk.surfaces == kMaxBounces) return false;
        if (at.bsdf.is_glass()) return true;
        return ++walk.bounces <= kRouletteAfter || survives_roulette(walk, kMaxSurvival, sampler_);
    }

    const SceneData& scene_;
    Sampler& sampler_;
    PathResult result_;
};

}  // namespace

PathResult PathTracer::trace(const Ray& ray, Sampler& sampler) const
{
    return Path(scene_, sampler).traced(ray);
}

void require_partial_coverage(const SceneData& scene, bool texels_have_it)
{
    if (texels_have_it || !scene.medium || scene.mesh_is_shell) return;
    throw BakeError(
        "the scene's 'volume' is half transparent and needs texels that are partly covered; bake with --layout "
        "chord --texel palette8");
}

uint64_t tracing_fingerprint(const SceneData& scene)
{
    constexpr uint32_t kPathProbes = 2048;
    constexpr uint64_t kProbeSeed = 0x70726F6265;
    const detail::Lattice places(kPathProbes);
    const float radius = 2 / std::sqrt(static_cast<float>(kPathProbes));  // a place's share of the sphere, as a disc
    const PathTracer tracer(scene);
    Digest digest;
    for (uint32_t k = 0; k < kPathProbes; ++k) {
        const uint32_t j = static_cast<uint32_t>(uint64_t{k} * 0x9E3779B9u % kPathProbes);
        const Frame frame(unit_vector(detail::point(places, k)));
        const Vec3 target = unit_vector(detail::point(places, j));
        Sampler sampler(kProbeSeed, k, j);
        const auto path_from = [&](const Vec2& u) -> std::optional<PathResult> {
            const Vec2 d = square_to_disc(u);
            const Vec3 start = frame.normal + frame.tangent * (radius * d.x) + frame.bitangent * (radius * d.y);
            const Vec3 towards = target - start;
            const float distance = length(towards);
            if (!(distance > 0)) return std::nullopt;
            return tracer.trace({start, towards / distance, distance}, sampler);
        };
        sampler.start(0);
        Estimate estimate(scene.tone);
        estimate.add(path_from(sampler.next_2d()).value_or(PathResult{}));
        digest.add(estimate.covered_colour());
        sampler.start(0);
        if (const std::optional<PathResult> path = path_from({})) {
            digest.add(path->covered);
            digest.add(path->radiance);
        }
    }
    return digest.value()[0];
}

}  // namespace lumi::baker
