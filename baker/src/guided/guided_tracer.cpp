// SPDX-License-Identifier: MIT
#include "guided/guided_tracer.h"

#include "image/srgb.h"
#include "image/tone.h"
#include "math/warp.h"
#include "proxy/proxy_fit.h"
#include "trace/surface.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kPointSeedOffset = 0x706F696E;  // paths of mean colours are independent of those of texels

}  // namespace

GuidedTracer::GuidedTracer(const SceneData& scene, const ProxyTracer* proxy, uint32_t samples, float jitter,
                           uint64_t seed)
    : scene_(scene), proxy_(proxy), tracer_(scene), samples_(samples), jitter_(jitter), seed_(seed)
{
}

std::optional<float> GuidedTracer::surface(const Ray& ray) const
{
    if (!proxy_) {
        return 0.0f;
    }
    const std::optional<Hit> hit = proxy_->closest(ray);
    return hit ? std::optional<float>(hit->distance) : std::nullopt;
}

std::optional<Rgb> GuidedTracer::light(const Ray& ray, float surface, Sampler& sampler) const
{
    if (proxy_) {
        Sampler same = sampler;  // the path's first hit draws the same numbers
        const std::optional<Hit> hit = closest_opaque(scene_, ray, same);
        if (!hit || std::abs(hit->distance - surface) > kMaxDepthError) {
            return std::nullopt;
        }
    }
    const PathResult path = tracer_.trace(ray, sampler);
    return path.covered ? std::optional<Rgb>(path.radiance) : std::nullopt;
}

Levels GuidedTracer::encoded(const Rgb& sum, uint32_t count) const
{
    const Rgb c = toned(scene_.tone, sum * (1 / static_cast<float>(count)));
    return {255 * srgb_encode_unit(c.r), 255 * srgb_encode_unit(c.g), 255 * srgb_encode_unit(c.b)};
}

std::optional<ColourAtPoint> GuidedTracer::point(const ChartGeometry& chart, uint32_t origin, uint32_t k,
                                                 const Vec2& grid_point, uint32_t paths) const
{
    Sampler sampler(seed_ + kPointSeedOffset, origin, k);
    const Vec2 offset = sampler.next_2d();
    const std::optional<Ray> ray = chart.ray({grid_point.x + offset.x - 0.5f, grid_point.y + offset.y - 0.5f});
    const std::optional<float> distance = ray ? surface(*ray) : std::nullopt;
    if (!distance) {
        return std::nullopt;
    }
    Rgb sum;
    uint32_t count = 0;
    for (uint32_t s = 0; s < paths; ++s) {
        sampler.start(s);
        if (const std::optional<Rgb> radiance = light(*ray, *distance, sampler)) {
            sum = sum + *radiance;
            ++count;
        }
    }
    if (count == 0) {
        return std::nullopt;
    }
    return ColourAtPoint{ray->origin + ray->direction * *distance, encoded(sum, count)};
}

TexelEstimate GuidedTracer::texel(const ChartGeometry& chart, uint32_t origin, uint32_t u, uint32_t v,
                                  const MeanColour* mean) const
{
    TexelEstimate result;
    Rgb sum;
    Levels means;
    uint32_t count = 0;
    const float radius = jitter_ * chart.cell_radius();
    Sampler sampler(seed_, origin, v * chart.side() + u);
    for (uint32_t s = 0; s < samples_; ++s) {
        sampler.start(s);
        const Vec2 disc = square_to_disc(sampler.next_2d());
        const Vec2 step = chart.grid_step({disc.x * radius, disc.y * radius});
        const std::optional<Ray> ray = chart.ray({static_cast<float>(u) + step.x, static_cast<float>(v) + step.y});
        const std::optional<float> distance = ray ? surface(*ray) : std::nullopt;
        if (!distance) {
            continue;
        }
        result.farthest = std::max(result.farthest, *distance);
        if (const std::optional<Rgb> radiance = light(*ray, *distance, sampler)) {
            sum = sum + *radiance;
            means =
                mean ? means + trilinear(mean->grid, mean->colours, ray->origin + ray->direction * *distance) : means;
            ++count;
        }
    }
    // On a focus surface a missing texel is what lets the background through.
    result.known = proxy_ ? count != 0 : 2 * count >= samples_;
    if (result.known) {
        result.levels = encoded(sum, count) - means * (1 / static_cast<float>(count));
    }
    return result;
}

}  // namespace lumi::baker
