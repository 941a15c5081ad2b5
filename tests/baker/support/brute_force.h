// SPDX-License-Identifier: MIT
// An integrator that shares nothing with the path tracer but rays and surfaces, and a room to compare them in.
#pragma once

#include "math/warp.h"
#include "support/shapes.h"
#include "support/statistics.h"
#include "trace/hit_point.h"
#include "trace/path_tracer.h"

namespace lumi::baker::testing
{

// The plainest path tracer there is: it never aims at lights and never plays roulette.
class BruteForce : public Integrator
{
public:
    explicit BruteForce(const SceneData& scene) : scene_(scene) {}

    PathResult trace(const Ray& first, Sampler& sampler) const override
    {
        PathResult result;
        Rgb throughput = grey(1);
        Ray ray = first;
        const Material* medium = nullptr;
        for (int bounce = 0; bounce < kMaxBounces; ++bounce) {
            const std::optional<Hit> hit = closest_opaque(scene_, ray, sampler);
            const float free = hit ? hit->distance : ray.end;
            const float stop =
                !scene_.medium ? free
                               : scene_.medium->collision({ray.origin, ray.direction, free}, sampler).value_or(free);
            if (result.covered) {
                scene_.lights.for_each_seen(
                    {ray.origin, ray.direction, stop},
                    [&](const Rgb& light, float) { result.radiance = result.radiance + throughput * light; });
            }
            if (stop < free) {
                result.covered = true;
                const Vec3 position = ray.origin + ray.direction * stop;
                throughput = throughput * scene_.medium->colour(position);
                ray = {position, scene_.medium->phase().sample(ray.direction, sampler.next_2d())};
                continue;
            }
            if (!hit) {
                if (result.covered)
                    result.radiance = result.radiance + throughput * scene_.lights.sky(ray.direction).radiance;
                break;
            }
            result.covered = true;
            throughput = medium ? throughput * medium->absorbed(hit->distance) : throughput;
            const HitPoint point = hit_point_at(scene_, ray, *hit);
            result.radiance = result.radiance + throughput * point.emission;
            const Vec3 wo = point.frame.to_local(-ray.direction);
            const Bsdf bsdf = point.material->bsdf(point.values, sampler.next_1d());
            const float u = sampler.next_1d();
            const std::optional<BsdfSample> s = bsdf.sample(wo, u, sampler.next_2d());
            if (!s) break;
            throughput = throughput * s->weight;
            if (s->wi.z < 0) medium = point.values.outside ? point.material : nullptr;
            ray = point.ray_towards(normalized(point.frame.to_world(s->wi)));
        }
        return result;
    }

private:
    const SceneData& scene_;
};

// Independent paths along rays from all around towards points near the centre.
inline std::vector<Mean> radiance(const Integrator& integrator, uint32_t paths, uint32_t rays, uint64_t seed)
{
    std::vector<Mean> means(rays);
    for (uint32_t r = 0; r < rays; ++r) {
        Sampler aim(99, r, 0);
        const Vec3 start = square_to_sphere(aim.next_2d()) * 1.5f;
        const Vec3 target = square_to_sphere(aim.next_2d()) * 0.3f;
        for (uint32_t k = 0; k < paths; ++k) {
            Sampler sampler(seed, r, k);
            const PathResult path = integrator.trace({start, normalized(target - start)}, sampler);
            means[r].add(static_cast<double>(luminance(path.radiance)));
        }
    }
    return means;
}

// A white floor, a red wall and a lamp.
inline void add_room(SceneMaker& maker)
{
    const uint32_t white = maker.add(testing::diffuse(grey(0.7f)));
    const uint32_t red = maker.add(testing::diffuse({0.6f, 0.1f, 0.1f}));
    maker.quad(white, {-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {-0.5f, 0.5f, -0.5f});
    maker.quad(red, {-0.5f, 0.5f, -0.5f}, {0.5f, 0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}, {-0.5f, 0.5f, 0.5f});
    const uint32_t light = maker.add(testing::lamp({6, 5, 4}));
    maker.quad(light, {-0.3f, -0.3f, 0.55f}, {0.3f, -0.3f, 0.55f}, {0.3f, 0.3f, 0.55f}, {-0.3f, 0.3f, 0.55f});
}

}  // namespace lumi::baker::testing
