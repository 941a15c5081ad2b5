// SPDX-License-Identifier: MIT
#include "mesh/mesh_draft.h"

#include "lumi/surface/format.h"
#include "mesh/edge_split.h"
#include "mesh/seen_part.h"
#include "mesh/simplify.h"

namespace lumi::baker
{
namespace
{

constexpr float kSplitEarly = 0.95f;  // edges are split above this share of the longest edge: fitting makes some longer
constexpr float kMostMove = 0.1f;     // how far a new vertex may move onto the scene, as a share of its edge's length
constexpr float kMinFacing = 0.5f;    // cosine between the surface that it moves to and the triangles around
constexpr double kEnoughSeen = 0.95;  // as a share of the triangles asked for
constexpr int kAttempts = 3;          // attempts to have enough of them seen
constexpr size_t kMaxTriangles = 65536;  // triangles that are fitted, hidden ones among them

// Moves the middle of an edge onto the scene's surface, where that is near and faces the same way.
PlaceMiddle onto(const SceneData& scene)
{
    return [&scene](const Vec3& middle, const Vec3& facing, float edge) {
        const float reach = kMostMove * edge;
        const Ray ray = {middle + facing * reach, -facing, 2 * reach};
        const std::optional<Hit> hit = scene.accelerator.closest(ray);
        if (!hit) return middle;
        const Vec3 area = scene.mesh.area_vector(hit->triangle);
        const bool alike = std::abs(dot(area, facing)) > kMinFacing * length(area);
        return alike ? ray.origin + ray.direction * hit->distance : middle;
    };
}

size_t seen_triangles(const Mesh& mesh, Faces faces, const ViewCap& cap, Job& job)
{
    return seen_part(MeshTracer(mesh, faces), job, cap).triangle_count();
}

Simplified simplified_in(Job& job, const Mesh& mesh, size_t triangles)
{
    Simplified result;
    job.run(1, [&](uint32_t) { result = simplified(mesh, triangles); });
    return result;
}

// With so many triangles that can be seen, where the scene has them.
Simplified simplified_as_seen(const Outside& outside, size_t triangles, const ViewCap& cap, Job& job)
{
    Simplified result = simplified_in(job, outside.mesh, triangles);
    double asked = static_cast<double>(triangles);
    for (int k = 1; k < kAttempts && result.mesh.triangle_count() < outside.mesh.triangle_count(); ++k) {
        const size_t seen = seen_triangles(result.mesh, outside.faces(), cap, job);
        if (seen == 0 || static_cast<double>(seen) >= kEnoughSeen * static_cast<double>(triangles)) break;
        asked *= static_cast<double>(triangles) / static_cast<double>(seen);
        result = simplified_in(job, outside.mesh, std::min(kMaxTriangles, static_cast<size_t>(asked)));
    }
    return result;
}

}  // namespace

MeshDraft drafted(const SceneData& scene, const Outside& outside, const MeshSettings& settings, Job& job)
{
    Simplified simple = simplified_as_seen(outside, settings.triangles, settings.cap, job);
    MeshDraft draft = {with_short_edges(std::move(simple.mesh), kSplitEarly * settings.longest_edge, onto(scene)),
                       simple.rough, false};
    draft.fits = draft.mesh.triangle_count() <= kMaxTriangles &&
                 seen_triangles(draft.mesh, outside.faces(), settings.cap, job) <= 2 * detail::format::kMaxPatches;
    return draft;
}

}  // namespace lumi::baker
