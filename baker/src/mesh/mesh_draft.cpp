// SPDX-License-Identifier: MIT
#include "mesh/mesh_draft.h"

#include "lumi/surface/format.h"
#include "mesh/edge_split.h"
#include "mesh/mesh_tracer.h"
#include "mesh/simplify/simplify.h"

namespace lumi::baker
{
namespace
{

constexpr float kSplitEarly = 0.95f;  // edges are split above this share of the longest edge: fitting makes some longer
constexpr double kEnoughSeen = 0.95;  // as a share of the triangles asked for
constexpr uint32_t kCountRays = 256;  // a triangle, where seen ones are only counted: hidden ones take all of them
constexpr int kAttempts = 3;          // attempts to have enough of them seen
constexpr size_t kMaxTriangles = 65536;           // triangles that are fitted, hidden ones among them
constexpr size_t kMostAsked = kMaxTriangles / 2;  // leaves room for edges that are split

size_t seen_triangles(const Mesh& mesh, Faces faces, const ViewCap& cap, Job& job)
{
    return seen_part(MeshTracer(mesh, faces), job, cap, kCountRays).triangle_count();
}

Mesh simplified_in(Job& job, const Outside& outside, size_t triangles)
{
    Mesh result;
    job.run(1, [&](uint32_t) { result = simplified(outside.mesh, triangles, outside.openness); });
    return result;
}

// With so many triangles that can be seen, where the scene has them.
Mesh simplified_as_seen(const Outside& outside, size_t triangles, const ViewCap& cap, Job& job)
{
    Mesh result = simplified_in(job, outside, triangles);
    double asked = static_cast<double>(triangles);
    for (int k = 1; k < kAttempts && result.triangle_count() < outside.mesh.triangle_count(); ++k) {
        const size_t seen = seen_triangles(result, outside.faces(), cap, job);
        if (seen == 0 || static_cast<double>(seen) >= kEnoughSeen * static_cast<double>(triangles)) break;
        asked *= static_cast<double>(triangles) / static_cast<double>(seen);
        result = simplified_in(job, outside, std::min(kMostAsked, static_cast<size_t>(asked)));
    }
    return result;
}

}  // namespace

MeshDraft drafted(const Outside& outside, const MeshSettings& settings, Job& job)
{
    Mesh simple = simplified_as_seen(outside, settings.triangles, settings.cap, job);
    const bool exact = simple.triangle_count() == outside.mesh.triangle_count();
    const MeshTracer fronts(outside.mesh, Faces::front);
    MeshDraft draft = {with_short_edges(std::move(simple), kSplitEarly * settings.longest_edge, onto(fronts)), exact,
                       false};
    draft.fits = draft.mesh.triangle_count() <= kMaxTriangles &&
                 seen_triangles(draft.mesh, outside.faces(), settings.cap, job) <= 2 * detail::format::kMaxPatches;
    return draft;
}

}  // namespace lumi::baker
