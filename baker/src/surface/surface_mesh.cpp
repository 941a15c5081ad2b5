// SPDX-License-Identifier: MIT
#include "surface/surface_mesh.h"

#include "lumi/surface_format.h"
#include "proxy/proxy_fit.h"
#include "proxy/proxy_loss.h"
#include "proxy/proxy_outside.h"
#include "proxy/proxy_seen.h"
#include "proxy/proxy_simplify.h"
#include "surface/edge_split.h"
#include "surface/patch_pairs.h"
#include "surface/rounded_mesh.h"
#include "surface/smooth_groups.h"

namespace lumi::baker
{
namespace
{

constexpr float kSplitEarly = 0.95f;  // of the longest edge: fitting makes some a little longer
constexpr float kReach = 0.1f;        // how far a new vertex may move onto the scene, of its edge's length
constexpr float kMinFacing = 0.5f;    // cosine between the surface that it moves to and the triangles around
constexpr float kFewerTriangles = 0.8f;
constexpr float kLongerEdges = 1.1f;

// Moves the middle of an edge onto the scene's surface, where that is near and faces the same way.
PlaceMiddle onto(const SceneData& scene)
{
    return [&scene](const Vec3& middle, const Vec3& facing, float edge) {
        const float reach = kReach * edge;
        const Ray ray = {middle + facing * reach, -facing, 2 * reach};
        const std::optional<Hit> hit = scene.accelerator.closest(ray);
        if (!hit) {
            return middle;
        }
        const Vec3 area = scene.mesh.area_vector(hit->triangle);
        const bool alike = std::abs(dot(area, facing)) > kMinFacing * length(area);
        return alike ? ray.origin + ray.direction * hit->distance : middle;
    };
}

Vec3 in_the_middle(const Vec3& middle, const Vec3&, float)
{
    return middle;
}

// Few triangles on the scene's surface, without edges that are too long.
Mesh drafted(const SceneData& scene, const Mesh& outside, const SurfaceMeshSettings& s)
{
    return with_short_edges(simplified(outside, s.triangles), kSplitEarly * s.longest_edge, onto(scene));
}

// Near the scene, in steps of the format.
Mesh shaped(const SceneData& scene, Mesh draft, bool two_sided, const SurfaceMeshSettings& s, Job& job)
{
    const Mesh fit = fitted_in_rounds(scene, std::move(draft), two_sided, job);
    const Mesh mesh = seen_part(ProxyTracer(fit, two_sided), job);
    return rounded(with_short_edges(mesh, s.longest_edge, in_the_middle));
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

bool may_fit(const Mesh& draft)
{
    return draft.positions.size() <= format::kMaxSurfaceVertices && draft.triangle_count() <= 2 * format::kMaxPatches;
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

}  // namespace

BuiltSurface build_surface_mesh(const SceneData& scene, const SurfaceMeshSettings& settings, Job& job)
{
    const Outside outside = outside_of(scene, job);
    BuiltSurface result;
    SurfaceMeshSettings s = settings;
    s.triangles = std::min(s.triangles, 2 * format::kMaxPatches);
    for (;; s = smaller(s)) {
        Mesh draft = drafted(scene, outside.mesh, s);
        if (!may_fit(draft)) {
            continue;
        }
        const Mesh shape = shaped(scene, std::move(draft), outside.two_sided, s, job);
        result.mesh = assembled(shape, settings.crease_cosine);
        if (fits(result.mesh)) {
            result.mesh.two_sided = outside.two_sided;
            result.loss = loss_of(scene, ProxyTracer(shape, outside.two_sided), job);
            return result;
        }
    }
}

}  // namespace lumi::baker
