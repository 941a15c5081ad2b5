// SPDX-License-Identifier: MIT
#include "lumi/baker/reference.h"

#include <algorithm>

#include "lumi/baker/bake.h"
#include "trace/camera_rays.h"
#include "trace/error_gauge.h"
#include "util/job.h"

namespace lumi::baker
{
namespace
{

Estimate pixel_estimate(ToneCurve tone, const CameraRays& rays, const Integrator& tracer,
                        const ReferenceSettings& settings, uint32_t x, uint32_t y)
{
    Estimate result(tone);
    Sampler sampler(settings.seed, y, x);
    for (uint32_t s = 0; s < settings.samples; ++s) {
        sampler.start(s);
        Vec2 place = sampler.next_2d();
        if (settings.samples == 1) place = {0.5f, 0.5f};
        const std::optional<Ray> ray = rays.ray(x + static_cast<double>(place.x), y + static_cast<double>(place.y));
        result.add(ray ? tracer.trace(*ray, sampler) : PathResult{});
    }
    return result;
}

// Traces every pixel; put(i, estimate) gets the i-th one, row by row, from several threads.
template <class Put>
void trace_pixels(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                  const ProgressCallback& progress, const Put& put)
{
    if (settings.samples == 0) throw BakeError("the number of samples must be at least 1");
    const uint32_t width = static_cast<uint32_t>(camera.width_px());
    const uint32_t height = static_cast<uint32_t>(camera.height_px());
    const CameraRays rays(camera);
    const PathTracer tracer(scene.data());
    Job job(uint64_t{width} * height * settings.samples, settings.threads, progress);
    job.run(height, [&](uint32_t y) {
        for (uint32_t x = 0; x < width && !job.stopping(); ++x) {
            put(size_t{width} * y + x, pixel_estimate(scene.data().tone, rays, tracer, settings, x, y));
            job.add_rays(settings.samples);
        }
    });
    job.finish();
}

size_t pixel_count(const Camera& camera)
{
    return static_cast<size_t>(camera.width_px()) * static_cast<size_t>(camera.height_px());
}

}  // namespace

RgbaImage render_reference(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                           const ProgressCallback& progress)
{
    RgbaImage image{camera.width_px(), camera.height_px(), std::vector<uint8_t>(4 * pixel_count(camera))};
    trace_pixels(scene, camera, settings, progress, [&](size_t pixel, const Estimate& estimate) {
        const detail::Rgba8 c = estimate.covered_colour();
        const uint8_t values[4] = {c.r, c.g, c.b, c.a};
        std::copy_n(values, 4, &image.rgba[4 * pixel]);
    });
    return image;
}

RadianceImage trace_radiance(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                             const ProgressCallback& progress)
{
    RadianceImage image{camera.width_px(), camera.height_px(), std::vector<float>(4 * pixel_count(camera))};
    trace_pixels(scene, camera, settings, progress, [&](size_t pixel, const Estimate& estimate) {
        const Rgb light = estimate.covered_radiance() * (1 / scene.data().choice.exposure);
        const float values[4] = {light.r, light.g, light.b, estimate.coverage()};
        std::copy_n(values, 4, &image.rgba[4 * pixel]);
    });
    return image;
}

}  // namespace lumi::baker
