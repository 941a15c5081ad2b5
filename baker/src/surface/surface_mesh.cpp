// SPDX-License-Identifier: MIT
#include "surface/surface_mesh.h"

#include "lumi/surface_format.h"
#include "proxy/proxy_fit.h"
#include "proxy/proxy_loss.h"
#include "proxy/proxy_seen.h"
#include "proxy/silhouettes.h"
#include "surface/edge_split.h"
#include "surface/mesh_draft.h"
#include "surface/mesh_warnings.h"
#include "surface/patch_pairs.h"
#include "surface/rounded_mesh.h"
#include "surface/smooth_groups.h"

namespace lumi::baker
{
namespace
{

constexpr float kFewerTriangles = 0.8f;
constexpr float kLongerEdges = 1.1f;

// Near the scene, in steps of the format.
Mesh shaped(const SceneData& scene, Mesh draft, bool two_sided, const SurfaceMeshSettings& s, Job& job)
{
    const Mesh fit = fitted_in_rounds(scene, std::move(draft), two_sided, job);
    const Mesh mesh = seen_part(ProxyTracer(fit, two_sided), job);
    return rounded(
        with_short_edges(mesh, s.longest_edge, [](const Vec3& middle, const Vec3&, float) { return middle; }));
}

SurfaceMesh assembled(const Mesh& shape, float crease_cosine)
{
    Mesh mesh = with_creases(shape, crease_cosine);
    SurfaceMesh result;
    result.patches = paired(mesh);
    for (size_t k = 0; k < mesh.triangle_count(); ++k) {
        for (size_t i = 0; i < 3; ++i) {
            const float edge = length(mesh.position(k, i) - mesh.position(k, (i + 1) % 3));
            result.longest_edge = std::max(result.longest_edge, edge);
        }
    }
    result.positions = std::move(mesh.positions);
    result.normals = std::move(mesh.normals);
    return result;
}

bool fits(const SurfaceMesh& mesh)
{
    return mesh.positions.size() <= format::kMaxSurfaceVertices && mesh.patches.size() <= format::kMaxPatches;
}

// What asks for a smaller mesh: fewer triangles, or longer edges where most triangles come from splitting.
SurfaceMeshSettings smaller(SurfaceMeshSettings s)
{
    if (s.triangles > format::kMaxPatches / 2) {
        s.triangles = static_cast<uint32_t>(kFewerTriangles * static_cast<float>(s.triangles));
    } else {
        s.longest_edge *= kLongerEdges;
    }
    return s;
}

ProxyLoss loss_of(const SceneData& scene, const ProxyTracer& shape, bool rough, Job& job)
{
    ProxyLoss loss = loss_of(scene, shape, job);
    const MissingPixels pixels = missing_pixels(scene, shape, job);
    loss.rough = rough;
    loss.holes = pixels.regions;
    loss.largest_hole = pixels.largest;
    return loss;
}

}  // namespace

BuiltSurface build_surface_mesh(const SceneData& scene, const SurfaceMeshSettings& settings, Job& job)
{
    const Outside outside = outside_of(scene, job);
    BuiltSurface result;
    SurfaceMeshSettings s = settings;
    s.triangles = std::min(s.triangles, 2 * format::kMaxPatches);
    for (;; s = smaller(s)) {
        MeshDraft draft = drafted(scene, outside, s, job);
        if (!draft.fits) {
            continue;
        }
        const Mesh shape = shaped(scene, std::move(draft.mesh), outside.two_sided, s, job);
        result.mesh = assembled(shape, settings.crease_cosine);
        if (fits(result.mesh)) {
            result.mesh.two_sided = outside.two_sided;
            result.loss = loss_of(scene, ProxyTracer(shape, outside.two_sided), draft.rough, job);
            result.warnings = mesh_warnings(result.loss, std::min<size_t>(s.triangles, outside.mesh.triangle_count()),
                                            shape.triangle_count());
            return result;
        }
    }
}

}  // namespace lumi::baker
