// SPDX-License-Identifier: MIT
#include "lumi/baker/surface.h"

#include "fit/texel_layout.h"
#include "lumi/surface/format.h"
#include "store/bake_stages.h"
#include "store/output_names.h"
#include "store/section_writer.h"
#include "trace/catcher.h"

namespace lumi::baker
{
namespace
{

constexpr size_t kMostSections = 7;

uint64_t file_bytes(const PatchMesh& mesh, uint64_t texels)
{
    const uint64_t vertices = mesh.positions.size(), patches = mesh.patches.size();
    uint64_t bytes = aligned(detail::format::kHeaderBytes + kMostSections * detail::format::kEntryBytes);
    for (const uint64_t section :
         {uint64_t{detail::format::kSurfaceBytes}, vertices * detail::format::kVertexBytes,
          patches * detail::format::kPatchBytes, texels, uint64_t{3 * detail::format::kPaletteEntries},
          patches * detail::format::kNeighbourBytes,
          detail::format::kViewColoursBytes + vertices * detail::format::kViewBytes})
        bytes += aligned(section);
    return bytes;
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
    built_ = std::make_unique<BuiltMesh>(build_mesh(scene.data(), mesh, stages, job));
}

SurfaceDraft::~SurfaceDraft() = default;
SurfaceDraft::SurfaceDraft(SurfaceDraft&&) noexcept = default;
SurfaceDraft& SurfaceDraft::operator=(SurfaceDraft&&) noexcept = default;

uint32_t SurfaceDraft::triangles() const
{
    uint32_t triangles = 0;
    for (const PatchMesh::Patch& patch : built_->mesh.patches) triangles += patch.d == PatchMesh::kNone ? 1u : 2u;
    return triangles;
}

const MeshLoss& SurfaceDraft::loss() const
{
    return built_->loss;
}

const std::vector<std::string>& SurfaceDraft::warnings() const
{
    return built_->warnings;
}

uint64_t SurfaceDraft::most_bytes(float texels_per_radius) const
{
    const PatchMesh& mesh = built_->mesh;
    return file_bytes(mesh, layout_of(mesh, texels_per_radius).texels);
}

}  // namespace lumi::baker
