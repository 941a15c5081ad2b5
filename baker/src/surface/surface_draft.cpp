// SPDX-License-Identifier: MIT
#include "lumi/baker/surface.h"

#include <algorithm>

#include "fit/texel_layout.h"
#include "lumi/surface/format.h"
#include "mesh/see_through.h"
#include "pack/view_quantiser.h"
#include "store/bake_stages.h"
#include "store/output_names.h"
#include "store/section_writer.h"
#include "trace/catcher.h"

namespace lumi::baker
{
namespace
{

constexpr size_t kMostSections = 7;  // of opaque fields

uint64_t file_bytes(const PatchMesh& mesh, uint64_t texels)
{
    const uint64_t vertices = mesh.positions.size(), patches = mesh.patches.size();
    const bool has_see_through = mesh.see_through_patches != 0;
    const size_t sections = kMostSections + (has_see_through ? 1 : 0);
    uint64_t bytes = aligned(detail::format::kHeaderBytes + sections * detail::format::kEntryBytes);
    for (const uint64_t section :
         {uint64_t{detail::format::kSurfaceBytes}, vertices * detail::format::kVertexBytes,
          patches * detail::format::kPatchBytes, texels, uint64_t{3 * detail::format::kPaletteEntries},
          patches * detail::format::kNeighbourBytes, planned_view_bytes(mesh)})
        bytes += aligned(section);
    return has_see_through ? bytes + aligned(detail::format::kSeeThroughBytes) : bytes;
}

uint32_t triangles_of(const PatchMesh& mesh)
{
    uint32_t triangles = 0;
    for (const PatchMesh::Patch& patch : mesh.patches) triangles += patch.d == PatchMesh::kNone ? 1u : 2u;
    return triangles;
}

// Both parts of the scene, where one sees through some of it.
BuiltMesh built_mesh(const SceneData& scene, MeshSettings mesh, BakeStages& stages, Job& job)
{
    constexpr uint32_t kSeeThroughParts = 4, kFewest = 64, kSides = 2;
    const std::unique_ptr<SceneData> opaque = opaque_part(scene);
    if (!opaque) return build_mesh(scene, mesh, stages, job);
    for (;; mesh.triangles = mesh.triangles / 4 * 3) {
        BuiltMesh built = opaque->mesh.corners.empty() ? BuiltMesh() : build_mesh(*opaque, mesh, stages, job);
        const uint32_t most = mesh.triangles + mesh.triangles / 2, opaque_ones = triangles_of(built.mesh);
        const uint32_t left = mesh.triangles - std::min(mesh.triangles, opaque_ones);
        const uint32_t few = std::max({kFewest, mesh.triangles / kSeeThroughParts, left / kSides});
        const uint32_t cards = std::max(few, most - std::min(most, opaque_ones));  // which have no view tables
        const size_t room =
            detail::format::kMaxPatches - std::min<size_t>(detail::format::kMaxPatches, built.mesh.patches.size());
        add_see_through(scene, *opaque, mesh, {few, cards, room}, built, job);
        if (fits(built.mesh)) return built;
        if (mesh.triangles < kFewest) throw BakeError("the scene's see-through parts are too many for a surface field");
    }
}

bool has_bending_glass(const SceneData& scene)
{
    return std::any_of(
        scene.mesh.materials.begin(), scene.mesh.materials.end(),
        [&](uint32_t material) { return scene.materials[material].glass; });
}

}  // namespace

SurfaceDraft::SurfaceDraft(const Scene& scene, const SurfaceSettings& settings, const ProgressCallback& progress,
                           const std::filesystem::path& output)
{
    require_partial_coverage(scene.data(), false);
    MeshSettings mesh;
    mesh.triangles = settings.triangles;
    mesh.longest_edge = settings.longest_edge;
    mesh.cap = ViewCap(settings.cap);
    Job job(mesh_work(scene.data(), mesh), settings.threads, progress);
    BakeStages stages(output.empty() ? output : stages_of(output), scene.fingerprint());
    built_ = std::make_unique<BuiltMesh>(built_mesh(scene.data(), mesh, stages, job));
    if (has_bending_glass(scene.data()))
        built_->warnings.push_back(
            {"the scene has bodies of glass, of which a surface field shows a coarse colour that depends on the view",
             "give thin panes an opacity (d) instead"});
}

SurfaceDraft::~SurfaceDraft() = default;
SurfaceDraft::SurfaceDraft(SurfaceDraft&&) noexcept = default;
SurfaceDraft& SurfaceDraft::operator=(SurfaceDraft&&) noexcept = default;

uint32_t SurfaceDraft::triangles() const
{
    return triangles_of(built_->mesh);
}

uint32_t SurfaceDraft::vertices() const
{
    return static_cast<uint32_t>(built_->mesh.positions.size());
}

uint32_t SurfaceDraft::patches() const
{
    return static_cast<uint32_t>(built_->mesh.patches.size()) - see_through_patches();
}

uint32_t SurfaceDraft::see_through_patches() const
{
    return static_cast<uint32_t>(built_->mesh.see_through_patches);
}

const MeshLoss& SurfaceDraft::loss() const
{
    return built_->loss;
}

const std::vector<MeshWarning>& SurfaceDraft::warnings() const
{
    return built_->warnings;
}

uint64_t SurfaceDraft::most_bytes(float texels_per_radius) const
{
    const PatchMesh& mesh = built_->mesh;
    return file_bytes(mesh, layout_of(mesh, texels_per_radius).texels);
}

}  // namespace lumi::baker
