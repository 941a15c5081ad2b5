// SPDX-License-Identifier: MIT
#include "image/srgb.h"
#include "lumi/baker/surface.h"
#include "store/new_file.h"
#include "surface/surface_tracer.h"
#include "surface/surface_writer.h"
#include "surface/texel_palette.h"
#include "trace/catcher.h"

namespace lumi::baker
{

SurfaceBake surface_field(const Scene& scene, const SurfaceSettings& settings, const ProgressCallback& progress)
{
    const SceneData& data = scene.data();
    Job job(1, settings.threads, progress);
    BuiltSurface built = build_surface_mesh(data, {settings.triangles, settings.longest_edge}, job);
    SurfaceBake bake;
    bake.loss = built.loss;
    const SurfaceShape shape(std::move(built.mesh), settings.texels_per_radius);
    const SurfaceTracer tracer(data, shape);
    const uint32_t batches = 300;
    std::vector<std::vector<SurfaceSample>> samples(batches);
    job.run(batches, [&](uint32_t k) { samples[k] = tracer.samples(settings.seed, k); });
    std::vector<Rgb> sums(shape.layout.texels);
    std::vector<float> counts(shape.layout.texels);
    for (const auto& batch : samples) {
        for (const SurfaceSample& s : batch) {
            sums[s.texel] = sums[s.texel] + s.radiance;
            counts[s.texel] += 1;
        }
    }
    std::vector<LevelColour> texels(shape.layout.texels);
    for (size_t k = 0; k < texels.size(); ++k) {
        const Rgb c = toned(data.tone, sums[k] * (1 / std::max(1.0f, counts[k])));
        texels[k] = {255 * srgb_encode_unit(c.r), 255 * srgb_encode_unit(c.g), 255 * srgb_encode_unit(c.b)};
    }
    PalettedTexels p = paletted(texels);
    SurfaceParts parts = {data.centre, data.radius, p.palette, p.texels, {}, {}};
    parts.views.resize(shape.mesh.positions.size());
    bake.file = surface_file(shape, parts);
    bake.vertices = static_cast<uint32_t>(shape.mesh.positions.size());
    bake.texels = shape.layout.texels;
    job.finish();
    return bake;
}

SurfaceBake bake_surface(const Scene& scene, const SurfaceSettings& settings, const std::filesystem::path& output,
                         const ProgressCallback& progress, Earlier)
{
    SurfaceBake bake = surface_field(scene, settings, progress);
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    return bake;
}

}  // namespace lumi::baker
