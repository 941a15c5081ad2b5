// SPDX-License-Identifier: MIT
#include "lumi/baker/surface.h"

#include "store/new_file.h"
#include "surface/surface_draft.h"
#include "surface/surface_fit.h"
#include "surface/texel_palette.h"
#include "surface/view_quantiser.h"

namespace lumi::baker
{
namespace
{

void describe(const SurfaceShape& shape, SurfaceBake& bake)
{
    bake.vertices = static_cast<uint32_t>(shape.mesh.positions.size());
    bake.texels = shape.layout.texels;
    bake.two_sided = shape.mesh.two_sided;
    for (const SurfaceMesh::Patch& patch : shape.mesh.patches) {
        bake.triangles += patch.d == SurfaceMesh::kNone ? 1u : 2u;
    }
}

// The nodes as they can be stored, then the texels that go with them.
SurfaceParts quantised_parts(const SceneData& scene, const SurfaceFit& fit, const SurfaceSettings& settings, Job& job)
{
    const size_t vertices = fit.sums().shape().mesh.positions.size();
    std::vector<uint8_t> viewed(vertices, 0);
    if (settings.view_tables) {
        viewed = viewed_vertices(fit.sums(), fit.solve({}, job));
    }
    SurfaceModel model = fit.solve(viewed, job);
    QuantisedViews views = quantised(fit.sums(), model, viewed);
    model.nodes = decoded(views);
    fit.refit_texels(model, job);
    PalettedTexels texels = paletted(model.texels);
    return {scene.centre,  scene.radius,          texels.palette, std::move(texels.texels),
            views.colours, std::move(views.views)};
}

}  // namespace

SurfaceBake surface_field(const Scene& scene, const SurfaceSettings& settings, const ProgressCallback& progress,
                          const SurfaceDraft* draft)
{
    if (draft == nullptr) {
        const SurfaceDraft own(scene, settings, progress);
        return surface_field(scene, settings, progress, &own);
    }
    const SceneData& data = scene.data();
    SurfaceBake bake;
    Job job(1, settings.threads, progress);
    const BuiltSurface& built = draft->contents().built;
    bake.loss = built.loss;
    const SurfaceShape shape(built.mesh, settings.texels_per_radius);
    describe(shape, bake);
    SurfaceFit fit(data, shape, settings);
    fit.trace(progress);
    bake.paths = fit.paths();
    const SurfaceParts parts = quantised_parts(data, fit, settings, job);
    for (const ViewCode& view : parts.views) {
        bake.viewed_vertices += view.gain != 0 ? 1u : 0u;
    }
    bake.file = surface_file(shape, parts);
    return bake;
}

SurfaceBake bake_surface(const Scene& scene, const SurfaceSettings& settings, const std::filesystem::path& output,
                         const ProgressCallback& progress, Earlier, const SurfaceDraft* draft)
{
    SurfaceBake bake = surface_field(scene, settings, progress, draft);
    NewFile file(output);
    file.append(bake.file);
    file.commit();
    return bake;
}

}  // namespace lumi::baker
