// SPDX-License-Identifier: MIT
#include "lumi/baker/reference.h"

#include "lumi/baker/bake.h"
#include "trace/camera_rays.h"
#include "trace/estimate.h"
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
        if (settings.samples == 1 || settings.through_centre) place = {0.5f, 0.5f};
        const std::optional<Ray> ray = rays.ray(x + static_cast<double>(place.x), y + static_cast<double>(place.y));
        result.add(ray ? tracer.trace(*ray, sampler) : PathResult{});
    }
    return result;
}

}  // namespace

RgbaImage render_reference(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                           const ProgressCallback& progress)
{
    if (settings.samples == 0) throw BakeError("the number of samples must be at least 1");
    const uint32_t width = static_cast<uint32_t>(camera.width_px());
    const uint32_t height = static_cast<uint32_t>(camera.height_px());
    RgbaImage image{camera.width_px(), camera.height_px(), std::vector<uint8_t>(size_t{4} * width * height)};
    const CameraRays rays(camera);
    const PathTracer tracer(scene.data());
    Job job(uint64_t{width} * height * settings.samples, settings.threads, progress);
    job.run(height, [&](uint32_t y) {
        uint8_t* out = image.rgba.data() + size_t{4} * width * y;
        for (uint32_t x = 0; x < width && !job.stopping(); ++x, out += 4) {
            const detail::Rgba8 c = pixel_estimate(scene.data().tone, rays, tracer, settings, x, y).covered_colour();
            out[0] = c.r;
            out[1] = c.g;
            out[2] = c.b;
            out[3] = c.a;
            job.add_rays(settings.samples);
        }
    });
    job.finish();
    return image;
}

}  // namespace lumi::baker
